// The shader library's functions against what they must be. Included once for each precision, inside a
// namespace that has Float, Vec3, ... and Program; SUITE(Name) makes the suite's name. Literals carry
// suffixes, or are exact.

namespace {

using Library = Program<RuntimeEffects>;

/// A library over one triangle.
struct Stage {
  PackedScene scene = test::oneTriangle();
  Library lib{scene, FrameConstants{}, EffectSet{}, RouletteMode::Throughput};
};

Vec3d toDouble(const Vec3& v) { return {v.x, v.y, v.z}; }
double number(long double x) { return static_cast<double>(x); }

/// How far (s, t, n) is from an orthonormal right-handed frame.
double frameError(const Library::Frame& f) {
  const Vec3d s = toDouble(f.s);
  const Vec3d t = toDouble(f.t);
  const Vec3d n = toDouble(f.n);
  double worst = 0;
  for (const double e : {glm::length(s) - 1, glm::length(t) - 1, glm::dot(s, t), glm::dot(s, n),
                         glm::dot(t, n), glm::dot(glm::cross(s, t), n) - 1})
    worst = std::max(worst, std::abs(e));
  return worst;
}

TEST(SUITE(Frame), IsOrthonormalForAllNormals) {
  Stage stage;
  test::Random random;
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i)
    worst = std::max(worst, frameError(stage.lib.makeFrame(random.direction<Vec3>())));
  // By x and y small, z from there: both poles, where Frisvad's frame breaks down.
  for (int i = 0; i < 200'000; ++i) {
    const double tilt = std::pow(10, random.between(-12, -1));
    const double phi = random.between(0, 2 * std::numbers::pi_v<double>);
    const double x = tilt * std::cos(phi);
    const double y = tilt * std::sin(phi);
    const double z = (i % 2 == 0 ? -1 : 1) * std::sqrt(1 - tilt * tilt);
    worst = std::max(worst, frameError(stage.lib.makeFrame(Vec3(Float(x), Float(y), Float(z)))));
  }
  // Both sides of the branch at n.z = -1/2.
  for (int i = 0; i < 100'000; ++i) {
    const double z = -number(0.5L) + random.between(-1, 1) * number(1e-6L);
    const double phi = random.between(0, 2 * std::numbers::pi_v<double>);
    const double r = std::sqrt(1 - z * z);
    worst = std::max(worst, frameError(stage.lib.makeFrame(
                                Vec3(Float(r * std::cos(phi)), Float(r * std::sin(phi)), Float(z)))));
  }
  EXPECT_LT(worst, number(1e-6L));
}

TEST(SUITE(Frame), AxesAreExact) {
  Stage stage;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      Vec3 n(0);
      n[axis] = Float(sign);
      EXPECT_EQ(frameError(stage.lib.makeFrame(n)), 0) << axis << " " << sign;
    }
  }
}

/// There and back; and by 4 sum^3 of area the square is the sphere: its solid angle and the moments of its
/// directions.
TEST(SUITE(Octahedron), IsTheSphere) {
  Stage stage;
  constexpr int kSteps = 512;
  double angle = 0;
  Vec3d first(0);
  Vec3d second(0);
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const Vec2 square((Float(i % kSteps) + Float(0.5L)) / Float(kSteps),
                      (Float(i / kSteps) + Float(0.5L)) / Float(kSteps));
    const Vec3d d = toDouble(stage.lib.fromOctahedron(square));
    ASSERT_NEAR(glm::length(d), 1, number(1e-6L));
    const Vec2 back = stage.lib.toOctahedron(stage.lib.fromOctahedron(square));
    ASSERT_NEAR(static_cast<double>(back.x), static_cast<double>(square.x), number(1e-6L));
    ASSERT_NEAR(static_cast<double>(back.y), static_cast<double>(square.y), number(1e-6L));
    const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    const double part = 4 * sum * sum * sum / (kSteps * kSteps);
    angle += part;
    first += part * d;
    second += part * d * d;
  }
  const double sphere = 4 * std::numbers::pi_v<double>;
  EXPECT_NEAR(angle, sphere, number(1e-3L));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(first[axis], 0, number(1e-3L));
    EXPECT_NEAR(second[axis], sphere / 3, number(1e-3L));
  }
}

/// Every direction of a bin lies in it, up to its edges.
TEST(SUITE(Octahedron), BinsAreSquares) {
  Stage stage;
  test::Random random;
  for (uint bin = 0; bin < kGuideBins; ++bin) {
    for (int i = 0; i < 16; ++i) {
      const auto within = [&](uint cell) {
        return Float((cell + random.between(number(0.01L), number(0.99L))) / kGuideEdge);
      };
      const Float x = within(bin % kGuideEdge);
      const Float y = within(bin / kGuideEdge);
      ASSERT_EQ(stage.lib.guideBinOf(stage.lib.fromOctahedron(Vec2(x, y))), bin);
    }
  }
}

TEST(SUITE(Warp), CosineHemisphereIsUnitAboveTheSurface) {
  Stage stage;
  test::Random random;
  const double tolerance =
      8 * static_cast<double>(kEpsilon); // a square root, a sine and a product a component
  for (int i = 0; i < 100'000; ++i) {
    const Float u = stage.lib.toUnit(i == 0 ? 0xFFFFFFFFU : random.bits());
    const Float v = stage.lib.toUnit(random.bits());
    const Vec3 w = stage.lib.squareToCosineHemisphere(Vec2(u, v));
    ASSERT_GT(w.z, 0);
    ASSERT_NEAR(glm::length(toDouble(w)), 1, tolerance);
  }
}

double fresnel(Stage& stage, double cosI, double eta) {
  Float cosT = 0;
  return stage.lib.fresnelDielectric(Float(cosI), Float(eta), cosT);
}

TEST(SUITE(Fresnel), SpotValues) { // D3: half the sum of the squared amplitudes
  Stage stage;
  const auto half = [](long double s, long double p) { return number((s * s + p * p) / 2); };
  EXPECT_NEAR(fresnel(stage, std::sqrt(number(0.5L)), number(1.5L)), half(0.3033370L, 0.0920134L),
              number(1e-6L));
  const double inside = std::cos(number(10) * std::numbers::pi_v<double> / 180);
  EXPECT_NEAR(fresnel(stage, inside, 1 / number(1.5L)), half(0.2094943L, 0.1904680L), number(1e-6L));
  const double brewster =
      1 / std::sqrt(1 + number(2.25L)); // tan = 1.5: nothing of p polarisation is reflected
  const double rs = (1 - number(2.25L)) / (1 + number(2.25L));
  EXPECT_NEAR(fresnel(stage, brewster, number(1.5L)), rs * rs / 2, number(1e-6L));
}

TEST(SUITE(Fresnel), EndsOfTheRange) {
  Stage stage;
  for (const long double n : {1.1L, 1.5L, 2.4L, 1e3L, 1e6L}) {
    for (const double eta : {number(n), number(1 / n)}) {
      const double r = (eta - 1) / (eta + 1);
      EXPECT_NEAR(fresnel(stage, 1, eta), r * r, number(1e-6L)) << eta;
      EXPECT_NEAR(fresnel(stage, 0, eta), 1, number(1e-6L)) << eta;
    }
  }
}

TEST(SUITE(Fresnel), EqualIndicesReflectNothing) {
  Stage stage;
  test::Random random;
  for (int i = 0; i < 10'000; ++i)
    ASSERT_EQ(fresnel(stage, random.unit(), 1), 0);
  for (const long double cosI : {0.0L, 1e-30L, 1e-8L, 1.0L})
    ASSERT_EQ(fresnel(stage, number(cosI), 1), 0);
}

/// Fresnel's equations in long double, as amplitudes.
long double exactFresnel(long double cosI, long double eta) {
  const long double sin2T = (1 - cosI * cosI) / (eta * eta);
  if (sin2T >= 1)
    return 1;
  const long double cosT = std::sqrt(1 - sin2T);
  const long double rs = (cosI - eta * cosT) / (cosI + eta * cosT);
  const long double rp = (eta * cosI - cosT) / (eta * cosI + cosT);
  return (rs * rs + rp * rp) / 2;
}

TEST(SUITE(Fresnel), AgreesWithTheEquationsAndStaysInRange) {
  Stage stage;
  test::Random random;
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const Float cosI = Float(random.unit());
    const Float n = Float(random.between(1, 3));
    const Float eta = i % 2 == 0 ? n : 1 / n;
    const double f = fresnel(stage, cosI, eta);
    ASSERT_GE(f, 0);
    ASSERT_LE(f, 1);
    // Near the critical angle F falls from 1 like a square root: what rounding does to sin^2 shows as its
    // root.
    const double sin2T = (1 - double(cosI) * cosI) / (double(eta) * eta);
    const double rounding = 8 * static_cast<double>(kEpsilon);
    const double tolerance =
        number(1e-6L) + 8 * (std::sqrt(std::abs(1 - sin2T) + rounding) - std::sqrt(std::abs(1 - sin2T)));
    const double error = std::abs(f - number(exactFresnel(cosI, eta)));
    worst = std::max(worst, error / tolerance);
  }
  EXPECT_LE(worst, 1);
}

TEST(SUITE(Fresnel), IsMonotoneAndFiniteAtTheCriticalAngle) { // D1
  Stage stage;
  const Float eta = Float(1 / number(1.5L));
  Float cosI = Float(std::sqrt(1 - double(eta) * double(eta)));
  for (int k = 0; k < 64; ++k)
    cosI = std::nextafter(cosI, Float(0));
  double last = 1;
  for (int k = -64; k <= 64; ++k) {
    const double f = fresnel(stage, cosI, eta);
    ASSERT_GE(f, 0);
    ASSERT_LE(f, 1);
    // Monotone but for the rounding of the amplitudes.
    ASSERT_LE(f, last + 8 * static_cast<double>(kEpsilon));
    last = f;
    cosI = std::nextafter(cosI, Float(1));
  }
  EXPECT_GT(last, number(0.9L));
}

TEST(SUITE(Fresnel), ConductorWithoutAbsorptionIsADielectric) {
  Stage stage;
  test::Random random;
  // (a2b2 + t0) / 2 is formed from squares as large as eta^2 = 9.
  const double tolerance = 64 * static_cast<double>(kEpsilon);
  for (int i = 0; i < 100'000; ++i) {
    const Float cosI = Float(random.unit());
    const Float eta = Float(random.between(1 + number(1e-3L), 3));
    ASSERT_NEAR(stage.lib.fresnelConductor(cosI, eta, 0), number(exactFresnel(cosI, eta)), tolerance)
        << cosI << " " << eta;
  }
}

TEST(SUITE(Fresnel), MetalStaysInRange) {
  Stage stage;
  test::Random random;
  for (int i = 0; i < 100'000; ++i) {
    const Float f = stage.lib.fresnelConductor(Float(random.unit()), Float(random.between(number(0.05L), 4)),
                                               Float(random.between(0, 8)));
    ASSERT_GE(f, 0);
    ASSERT_LE(double(f), 1 + 4 * static_cast<double>(kEpsilon));
  }
}

/// A direction and a normal on its side.
struct Incidence {
  Vec3 wo;
  Vec3 n;
};
Incidence incidence(test::Random& random) {
  const Vec3 n = random.direction<Vec3>();
  const Vec3 wo = random.direction<Vec3>();
  return {glm::dot(n, wo) < 0 ? -wo : wo, n};
}

/// Where light goes at a smooth surface behind which the index is m.
Vec3 throughGlass(Stage& stage, const Incidence& at, Float m, bool front, uint bits) {
  Library::Surface glass{};
  glass.m.bsdf = kBsdfDielectric;
  glass.m.ior = m;
  glass.n = glass.ng = at.n;
  glass.front = front;
  return stage.lib.sampleDielectric(glass, at.wo, Vec3(stage.lib.toUnit(bits))).wi;
}

TEST(SUITE(Glass), DirectionsObeySnell) {
  Stage stage;
  test::Random random;
  int refracted = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Incidence at = incidence(random);
    const Vec3d n = toDouble(at.n);
    const Vec3d wo = toDouble(at.wo);
    const Float m = Float(random.between(1, 3));
    const bool front = i % 2 == 0;
    const double eta = front ? double(m) : 1 / double(m);
    const Vec3d wi = toDouble(throughGlass(stage, at, m, front, i % 4 < 2 ? 0xFFFFFFFFU : random.bits()));
    const bool reflected = glm::dot(n, wi) > 0;
    // A few roundings of components up to 3 (an index), and of the angle's cosine, whose sine may be small.
    const double tolerance = 64 * static_cast<double>(kEpsilon);
    const Vec3d sines = glm::cross(n, wi) * (reflected ? 1 : eta);
    ASSERT_NEAR(glm::length(sines + glm::cross(n, wo)), 0, tolerance) << eta;
    ASSERT_NEAR(glm::length(wi), 1, tolerance);
    const double cosI = glm::dot(n, wo);
    ASSERT_TRUE(reflected || 1 - cosI * cosI <= eta * eta * (1 + tolerance))
        << "refracted beyond the critical angle";
    refracted += reflected ? 0 : 1;
  }
  EXPECT_GT(refracted, 50'000);
}

TEST(SUITE(Glass), ReflectsItsShare) {
  Stage stage;
  test::Random random;
  for (int i = 0; i < 20; ++i) {
    const Incidence at = incidence(random);
    const double share = fresnel(stage, glm::dot(toDouble(at.n), toDouble(at.wo)), number(1.5L));
    constexpr int kDraws = 20'000;
    int reflected = 0;
    for (int k = 0; k < kDraws; ++k)
      reflected +=
          glm::dot(throughGlass(stage, at, Float(number(1.5L)), true, random.bits()), at.n) > 0 ? 1 : 0;
    // Binomial; 20 tests at 4.5 deviations.
    ASSERT_NEAR(reflected, share * kDraws, number(4.5L) * std::sqrt(share * (1 - share) * kDraws) + 1);
  }
}

TEST(SUITE(Glass), IndexOneLetsRaysThrough) {
  Stage stage;
  test::Random random;
  for (int i = 0; i < 10'000; ++i) {
    const Incidence at = incidence(random);
    const Vec3 wi = throughGlass(stage, at, 1, true, 0);
    // cosT = sqrt(1 - (1 - cosI^2)): at grazing incidence the square root of a rounding.
    ASSERT_NEAR(glm::length(toDouble(wi) + toDouble(at.wo)), 0, 2 * std::sqrt(static_cast<double>(kEpsilon)));
  }
}

TEST(SUITE(Numbers),
     UnitIntervalIsHalfOpen) { // M7: 24 bits decide, so these are all values there are at the ends
  Stage stage;
  EXPECT_EQ(stage.lib.toUnit(0), 0);
  EXPECT_EQ(double(stage.lib.toUnit(0xFFFFFFFFU)), 1 - number(0x1p-24L));
  Float last = -1;
  for (std::uint64_t bits = 0; bits < (1ULL << 32U); bits += 256) {
    const Float u = stage.lib.toUnit(static_cast<uint>(bits));
    ASSERT_GT(u, last);
    last = u;
  }
  EXPECT_LT(last, 1);
}

/// Correlation of the first output of neighbouring counters along each of them.
TEST(SUITE(Numbers), NeighbouringCountersAreUncorrelated) {
  Stage stage;
  constexpr uint kPairs = 1'000'000;
  for (int step = 0; step < 4; ++step) {
    for (int output = 0; output < 4; ++output) {
      double sum = 0;
      for (uint i = 0; i < kPairs; ++i) {
        UVec4 counter(i % 1000, i / 1000, 3, 42);
        const UVec4 a = stage.lib.pcg4d(counter);
        counter[step] += 1;
        const UVec4 b = stage.lib.pcg4d(counter);
        sum += (double(stage.lib.toUnit(a[output])) - number(0.5L)) *
               (double(stage.lib.toUnit(b[output])) - number(0.5L));
      }
      // Standardised: the variance of a uniform number is 1/12. 16 tests at 4.5 sigma: 1e-4 to fail by
      // chance.
      EXPECT_LT(std::abs(12 * sum / kPairs), number(4.5L) / std::sqrt(double(kPairs)))
          << step << " " << output;
    }
  }
}

TEST(SUITE(Numbers), BlocksAreUniform) {
  Stage stage;
  constexpr uint kBins = 256;
  constexpr uint kCount = 1U << 20U;
  for (uint block = 0; block < 4; ++block) {
    for (int output = 0; output < 4; ++output) {
      std::array<uint, kBins> bins{};
      for (uint i = 0; i < kCount; ++i)
        ++bins[stage.lib.randomBlock(i % 1024, i / 1024, block, 0)[output] >> 24U];
      double chi2 = 0;
      const double expected = double(kCount) / kBins;
      for (const uint n : bins)
        chi2 += (n - expected) * (n - expected) / expected;
      // chi^2 of 255 degrees of freedom: mean 255, deviation sqrt(510); 5 deviations, in 16 tests.
      EXPECT_NEAR(chi2, kBins - 1, 5 * std::sqrt(double(2 * (kBins - 1)))) << block << " " << output;
    }
  }
}

/// Sample number n of a replicate, whose groups of 16 come every fourth time.
inline uint sampleOfReplicate(uint replicate, uint n) {
  return (n / kSamplesPerGroup * kReplicates + replicate) * kSamplesPerGroup + n % kSamplesPerGroup;
}

/// Of 2^m points one falls into each elementary interval of area 2^-m: (0, m, 2)-nets, Niederreiter 1987.
inline bool isNet(const std::vector<std::array<uint, 2>>& points) {
  const auto m = static_cast<uint>(std::countr_zero(points.size()));
  for (uint columns = 0; columns <= m; ++columns) {
    std::vector<bool> taken(points.size());
    for (const auto& [x, y] : points) {
      const auto top = [](uint v, uint bits) { return bits == 0 ? 0U : v >> (32U - bits); };
      const uint cell = (top(x, columns) << (m - columns)) | top(y, m - columns);
      if (taken[cell])
        return false;
      taken[cell] = true;
    }
  }
  return true;
}

TEST(SUITE(Sobol), EveryPowerOfTwoOfAReplicateIsANet) {
  Stage stage;
  test::Random random;
  for (int trial = 0; trial < 200; ++trial) {
    const uint pixel = random.bits(), block = random.bits(), key = random.bits(),
               replicate = random.bits() % 4;
    const uint size = 1U << (random.bits() % 11U);
    const uint first = size * (random.bits() % 4U);
    std::vector<std::array<uint, 2>> xy, zw;
    for (uint n = first; n < first + size; ++n) {
      const UVec4 p = stage.lib.sobolBlock(pixel, sampleOfReplicate(replicate, n), block, key);
      xy.push_back({p.x, p.y});
      zw.push_back({p.z, p.w});
    }
    ASSERT_TRUE(isNet(xy)) << size << " points from " << first;
    ASSERT_TRUE(isNet(zw)) << size << " points from " << first;
  }
}

// No number of one point set goes with the same number of another one (5 deviations), nor does the order of
// 16 points. Of two numbers whose order first differs in bit l, each such pair lies in different halves of a
// stratum of 2^l numbers: their correlation is -3 4^-l / 2^(l-1), and that of 16 numbers of independent sets
// has a mean square of (1 + sum over l of 9 16^-l / 2^(l-1)) / 16.
TEST(SUITE(Sobol), PointSetsAreIndependent) {
  Stage stage;
  test::Random random;
  constexpr int kTrials = 20000;
  const auto centred = [](uint v) { return double(v) * number(0x1p-32L) - number(0.5L); };
  struct Other {
    const char* what;
    uint pixel, replicate, block, key;
  };
  for (const Other& other : {Other{"pair", 0, 0, 0, 0}, Other{"pixel", 1, 0, 0, 0},
                             Other{"replicate", 0, 1, 0, 0}, Other{"block", 0, 0, Library::kBlockStride, 0},
                             Other{"bounce", 0, 0, 1, 0}, Other{"seed", 0, 0, 0, 1}}) {
    double products = 0;
    double squares = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const uint pixel = random.bits(), block = random.bits(), key = random.bits();
      const bool pair = other.pixel + other.replicate + other.block + other.key == 0;
      double sum = 0;
      for (uint n = 0; n < kSamplesPerGroup; ++n) {
        const UVec4 a = stage.lib.sobolBlock(pixel, sampleOfReplicate(0, n), block, key);
        const UVec4 b = stage.lib.sobolBlock(pixel + other.pixel, sampleOfReplicate(other.replicate, n),
                                             block + other.block, key + other.key);
        sum += centred(a.x) * centred(pair ? b.z : b.x);
        if (n == 0)
          products += 12 * centred(a.x) * centred(pair ? b.z : b.x);
      }
      const double correlation = sum / (number(double(kSamplesPerGroup)) / 12);
      squares += correlation * correlation;
    }
    EXPECT_LT(std::abs(products), 5 * std::sqrt(double(kTrials))) << other.what;
    EXPECT_NEAR(squares / kTrials, number(0.0988L), number(0.005L)) << other.what; // 5 deviations
  }
}

TEST(SUITE(Sobol), PointsAreUniform) {
  Stage stage;
  constexpr uint kBins = 256;
  constexpr uint kCount = 1U << 20U;
  for (int output = 0; output < 4; ++output) {
    std::array<uint, kBins> bins{};
    for (uint pixel = 0; pixel < kCount; ++pixel)
      ++bins[stage.lib.sobolBlock(pixel, 3, 5, 7)[output] >> 24U];
    double chi2 = 0;
    const double expected = double(kCount) / kBins;
    for (const uint n : bins)
      chi2 += (n - expected) * (n - expected) / expected;
    EXPECT_NEAR(chi2, kBins - 1, 5 * std::sqrt(double(2 * (kBins - 1)))) << output;
  }
}

} // namespace
