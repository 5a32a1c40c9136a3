// Sums that neither stall nor cancel: Welford's update in float within a group of at most kSamplesPerGroup
// samples, Chan's merge of groups in pairs of floats (about 48 bits).

// Adds sample L as number n (1, 2, ...) of a group. A constant gives deviations of exactly 0, and no sample can
// make them negative: the new mean lies between the old one and L. Welford 1962, Technometrics 4(3).
void addSample(INOUT(Vec3) mean, INOUT(Vec3) deviations, Float n, Vec3 L) {
  precise Vec3 delta = L - mean;
  precise Vec3 next = n == 1.0 ? L : mean + delta / MUTATE(TooFewSamplesInMean, n, n + 1.0);
  precise Vec3 increment = delta * MUTATE(DeviationsFromOldMean, L - next, delta);
  deviations += n == 1.0 ? Vec3(0.0) : increment;
  mean = next;
}

// In these functions no variable is assigned twice: glslang 12 follows `precise` round such a cycle for ever.

// An unevaluated sum high + low, |low| <= ulp(high) / 2.
struct Pair {
  Float high;
  Float low;
};

Pair makePair(Float high, Float low) {
  Pair p;
  p.high = high;
  p.low = low;
  return p;
}

// Error-free sum of a and b: Knuth, TAOCP 2, 4.2.2.
Pair twoSum(Float a, Float b) {
  precise Float s = a + b;
  precise Float bb = s - a;
  precise Float aa = s - bb;
  precise Float eb = b - bb;
  precise Float ea = a - aa;
  precise Float e = ea + eb;
  return makePair(s, e);
}

// Error-free sum for |a| >= |b|: Dekker 1971.
Pair quickTwoSum(Float a, Float b) {
  precise Float s = a + b;
  precise Float d = s - a;
  precise Float e = b - d;
  return makePair(s, e);
}

// High half of a float's digits: Veltkamp's splitting. kSplitter = 2^ceil(digits / 2) + 1.
Float highHalf(Float a) {
  precise Float c = kSplitter * a;
  precise Float d = c - a;
  precise Float h = c - d;
  return h;
}

// Error-free product: Dekker 1971. No fma: a driver may round its product.
Pair twoProduct(Float a, Float b) {
  precise Float p = a * b;
  precise Float ah = highHalf(a);
  precise Float al = a - ah;
  precise Float bh = highHalf(b);
  precise Float bl = b - bh;
  precise Float e0 = ah * bh - p;
  precise Float e1 = e0 + ah * bl;
  precise Float e2 = e1 + al * bh;
  precise Float e = e2 + al * bl;
  return makePair(p, e);
}

Pair addPairs(Pair a, Pair b) {
  Pair s = twoSum(a.high, b.high);
  Pair t = twoSum(a.low, b.low);
  precise Float middle = s.low + t.high;
  Pair r = quickTwoSum(s.high, middle);
  precise Float low = r.low + t.low;
  return quickTwoSum(r.high, low);
}

Pair multiplyPairs(Pair a, Pair b) {
  Pair p = twoProduct(a.high, b.high);
  precise Float cross = a.high * b.low + a.low * b.high;
  precise Float low = p.low + cross;
  return quickTwoSum(p.high, low);
}

Pair negatePair(Pair a) { return makePair(-a.high, -a.low); }

// Quotient by long division, two correction steps.
Pair dividePairs(Pair a, Pair b) {
  precise Float q1 = a.high / b.high;
  Pair r = addPairs(a, negatePair(multiplyPairs(b, makePair(q1, 0.0))));
  precise Float q2 = r.high / b.high;
  Pair rest = addPairs(r, negatePair(multiplyPairs(b, makePair(q2, 0.0))));
  precise Float q3 = rest.high / b.high;
  Pair q = quickTwoSum(q1, q2);
  return addPairs(q, makePair(q3, 0.0));
}

// A 32-bit count without rounding.
Pair pairFromCount(uint n) { return twoSum(Float(n >> 16u) * 65536.0, Float(n & 0xFFFFu)); }

// Merges a group (nB samples, mean, deviations) into (nA samples, mean, deviations), one channel.
// Chan, Golub, LeVeque 1979, "Updating formulae and a pairwise algorithm for computing sample variances".
void mergeGroup(INOUT(Pair) mean, INOUT(Pair) deviations, uint nA, Float meanB, Float deviationsB, uint nB) {
  if (nA == 0u) {
    mean = makePair(meanB, 0.0);
    deviations = makePair(deviationsB, 0.0);
    return;
  }
  Pair delta = addPairs(makePair(meanB, 0.0), negatePair(mean));
  Pair share = dividePairs(pairFromCount(nB), pairFromCount(MUTATE(MergeMeanUnweighted, nA + nB, 2u * nB))); // nB / n
  Pair between = multiplyPairs(multiplyPairs(delta, delta), multiplyPairs(share, pairFromCount(nA)));
  Pair next = MUTATE(PlainSums, addPairs(mean, multiplyPairs(delta, share)),
                     makePair(mean.high + delta.high * share.high, 0.0));
  mean = makePair(next.high, MUTATE(MergeLowDropped, next.low, 0.0));
  Pair within = makePair(deviationsB, 0.0);
  deviations = addPairs(deviations, MUTATE(MergeBetweenDropped, addPairs(within, between), within));
}
