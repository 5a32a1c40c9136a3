// The shader library as a C++ class. Included by program32.h and program64.h inside their namespaces, where
// Float is defined.

#include "shared/language.h"

using namespace vkpt::shared; // the layouts and constants of shared/structs.h

// Literals of the library are plain: 0.5 must be a Float.
static_assert(std::is_same_v<decltype(0.5), Float>,
              "compile with vkpt_single_precision_literals() (src/host/CMakeLists.txt) if Float is float");

/// The library with its accessors over a PackedScene, which must outlive it. One object a thread.
/// Traits: Flag<id>, as RuntimeEffects has.
template<class Traits>
class Program {
public:
#include "lib/records.glsl"
#include "lib/block.glsl"

  Program(const PackedScene& scene, const FrameConstants& frame, const EffectSet& effects,
          RouletteMode roulette, PixelFilter::Shape filter = PixelFilter::Shape::Box,
          Sampler sampler = Sampler::Independent, uint reuseEdge = 1)
      :
#define VKPT_INITIALISE_EFFECT(id, Name, name, what) kEffect##Name(effects),
        VKPT_EFFECTS(VKPT_INITIALISE_EFFECT)
#undef VKPT_INITIALISE_EFFECT
            kRouletteMode(static_cast<uint>(roulette)),
        kByLightTree(scene.lightChoice.byTree), kByLightTables(scene.lightChoice.byTables), kLightTableBits(scene.lightChoice.tableBits),
        kBelowLightTables(scene.lightChoice.belowTables), kSampler(static_cast<uint>(sampler)), kFilterShape(static_cast<uint>(filter)), kReuseEdge(reuseEdge), m_scene(&scene),
        m_frame(frame) {
    if (scene.bvh.depth >= kMaxStackDepth)
      throw std::length_error("the BVH is too deep for the traversal's stack");
  }

#define VKPT_DECLARE_EFFECT(id, Name, name, what)                                                            \
  [[no_unique_address]] typename Traits::template Flag<id> kEffect##Name;
  VKPT_EFFECTS(VKPT_DECLARE_EFFECT)
#undef VKPT_DECLARE_EFFECT
  uint kRouletteMode;
  bool kByLightTree;
  bool kByLightTables;
  uint kLightTableBits;
  bool kBelowLightTables;
  uint kSampler;
  uint kFilterShape;
  uint kReuseEdge;
  bool kFromLight = false; // of the path at hand

  // --- accessors: as in shaders/device_memory.glsl ---
  Vec4 nodeBounds(uint node, uint row) const {
    const float* p = &m_scene->bvh.nodes[node].lowerX[0] + std::size_t{4} * row;
    return Vec4(p[0], p[1], p[2], p[3]);
  }
  UVec4 nodeChildren(uint node) const {
    const auto& c = m_scene->bvh.nodes[node].child;
    return UVec4(c[0], c[1], c[2], c[3]);
  }
  TriangleRecord triangleRecord(uint i) const {
    const Texel* t = &m_scene->triangles[std::size_t{i} * kTexelsPerTriangle];
    TriangleRecord r;
    r.v0 = vector(t[0]);
    r.v1 = vector(t[1]);
    r.v2 = vector(t[2]);
    r.material = t[0][3];
    r.id = t[1][3];
    r.lightLeaf = t[2][3];
    return r;
  }
  Vec3 triangleNormal(uint i, uint corner) const {
    return vector(m_scene->normals[std::size_t{i} * kTexelsPerTriangle + corner]);
  }
  Vec2 triangleUv(uint i, uint corner) const {
    const Texel* t = &m_scene->uvs[std::size_t{i} * kTexelsPerUv];
    const Texel& pair = t[corner / 2];
    const std::size_t at = 2 * std::size_t{corner % 2};
    return Vec2(number(pair[at]), number(pair[at + 1]));
  }
  Material material(uint i) const {
    const Texel* t = &m_scene->materials[std::size_t{i} * kTexelsPerMaterial];
    Material m;
    m.reflectance = vector(t[0]);
    m.bsdf = t[0][3] & 0xFFFFU;
    m.flags = t[0][3] >> 16U;
    m.emission = vector(t[1]);
    m.lightPdf_A = number(t[1][3]);
    m.eta = vector(t[2]);
    m.roughness = number(t[2][3]);
    m.k = vector(t[3]);
    m.ior = number(t[3][3]);
    m.specular = vector(t[4]);
    m.texture = t[4][3];
    m.absorption = vector(t[5]);
    return m;
  }
  TextureRecord textureRecord(uint i) const {
    const Texel& t = m_scene->textures[i];
    return {t[0], t[1], t[2]};
  }
  Vec3 texturePixel(uint pixel) const {
    const Texel& t = m_scene->textures[pixel / kPixelsPerTexel];
    const std::size_t at = 2 * std::size_t{pixel % kPixelsPerTexel};
    const glm::vec2 rg = glm::unpackHalf2x16(t[at]);
    return Vec3(rg.x, rg.y, glm::unpackHalf2x16(t[at + 1]).x);
  }
  EnvironmentRecord environmentRecord(uint i) const {
    const Texel* t = &m_scene->environment[std::size_t{i} * kTexelsPerEnvironmentTexel];
    EnvironmentRecord r;
    r.radiance = vector(t[0]);
    r.pdf_w = number(t[0][3]);
    r.threshold = number(t[1][0]);
    r.alias = t[1][1];
    return r;
  }
  LightRecord lightRecord(uint i) const {
    const Texel* t = &m_scene->lights[std::size_t{i} * kTexelsPerLight];
    LightRecord r;
    r.v0 = vector(t[0]);
    r.v1 = vector(t[1]);
    r.v2 = vector(t[2]);
    r.radiance = vector(t[3]);
    r.threshold = number(t[0][3]);
    r.alias = t[1][3];
    r.probability = number(t[2][3]);
    r.triangle = t[3][3];
    return r;
  }
  LightNode lightNode(uint i) {
    const Texel* t = &m_scene->lightNodes[std::size_t{i} * kTexelsPerLightNode];
    LightNode n;
    n.centre = vector(t[0]);
    n.radius = number(t[0][3]);
    n.axis = lightAxis(t[1][0]);
    n.cosSpread = number(t[1][1]);
    n.power = number(t[1][2]);
    n.below = t[1][3];
    return n;
  }
  LightNodePlace lightNodePlace(uint i) const {
    const Texel& t = m_scene->lightNodes[std::size_t{i} * kTexelsPerLightNode + 2];
    return {t[0], t[1]};
  }
  Vec3 lightGridLower() const { return vector(m_frame.lightGridLower); }
  Float lightGridCubesPerMetre() const { return m_frame.lightGridLower.w; }
  uint lightGridNumber(uint i) const { return m_scene->lightGrid[i]; }
  Vec3 guideLower() const { return vector(m_frame.guideLower); }
  Float guideCubesPerMetre() const { return m_frame.guideLower.w; }
  uint guideGridEdge() const { return m_frame.guideGridEdge; }
  uint guideStart(uint cube) const { return m_scene->guide[cube]; }
  AliasBin guideBin(uint histogram, uint bin) { return unpackBin(m_scene->guide[std::size_t{histogram} + bin], kGuideBits); }
  uint lightCount() const { return m_frame.lightCount; }
  uint maxBounces() const { return m_frame.maxBounces; }
  uint rouletteAfter() const { return m_frame.rouletteAfter; }
  Float survival() const { return m_frame.survival; }
  uint lightStrategy() const { return m_frame.lightStrategy; }
  uint lightSamples() const { return m_frame.lightSamples; }
  uint specularSamples() const { return m_frame.specularSamples; }
  uint splitDepth() const { return m_frame.splitDepth; }
  uint pathKinds() const { return m_frame.pathKinds; }
  uint deadHistories() const { return m_frame.deadHistories; }
  uint environmentWidth() const { return m_frame.environmentWidth; }
  uint environmentHeight() const { return m_frame.environmentHeight; }
  Float environmentProbability() const { return m_frame.environmentProbability; }
  uint environmentLeaf() const { return m_frame.environmentLeaf; }
  Vec4 filterShape() const {
    const vec4& f = m_frame.filterShape;
    return Vec4(f.x, f.y, f.z, f.w);
  }
  Float filterEdge(uint i) const {
    const vec4& group = m_frame.filterEdges[i / 4U];
    return (&group.x)[i % 4U];
  }
  Float sharedEyePdf_A() const { return m_frame.sharedEyePdf_A; }
  bool tracesLights() const { return kEffectLightTracing && m_frame.tracesLights != 0; }
  Vec3 specularLower(uint i) const { return vector(m_frame.specularLower[i]); }
  Vec3 specularUpper(uint i) const { return vector(m_frame.specularUpper[i]); }
  Float splatUnits() const { return m_frame.splatUnits; }
  Float splatSquareUnits() const { return m_frame.splatSquareUnits; }
  uint imageWidth() const { return m_frame.width; }
  uint imageHeight() const { return m_frame.height; }
  Vec3 cameraForward() const { return vector(m_frame.forward); }
  Float cameraImageArea() const { return m_frame.forward.w; }
  Vec3 background() const { return vector(m_frame.background); }
  Vec3 cameraEye() const { return vector(m_frame.eye); }
  Vec3 cameraUpperLeft() const { return vector(m_frame.upperLeft); }
  Vec3 cameraRight() const { return vector(m_frame.right); }
  Vec3 cameraDown() const { return vector(m_frame.down); }
  Float inverseWidth() const { return Float(1) / Float(m_frame.width); }
  Float inverseHeight() const { return Float(1) / Float(m_frame.height); }

  // --- branches that wait ---
  void storeBranch(uint i, const Branch& branch) { m_branches[i] = branch; }
  Branch loadBranch(uint i) const { return m_branches[i]; }

  // --- paths that the pixels of a block share, one sample at a time ---
  bool leavesVertices() const { return !kFromLight; }
  void keepFirstVertex(const FirstVertex& a) { m_shared[m_slot].first = a; }
  void keepSecondVertex(const SecondVertex& b, const Vec3& own) {
    m_shared[m_slot].second = b;
    m_shared[m_slot].own = own;
  }
  FirstVertex firstVertex(uint slot, uint /*sampleLow*/) const { return m_shared[slot].first; }
  SecondVertex secondVertex(uint slot, uint /*sampleLow*/) const { return m_shared[slot].second; }
  void storeBalance(uint slot, uint /*sampleLow*/, Float pdf_A) { m_shared[slot].light.pdf_A = pdf_A; }
  SharedLight sharedLight(uint slot, uint /*sampleLow*/) const { return m_shared[slot].light; }
  Vec3 ownLight(uint slot, uint /*sampleLow*/) const { return m_shared[slot].own; }
  void storeConnection(uint slot, uint /*sampleLow*/, uint member, Float pdf_A) {
    m_shared[slot].connections[member] = pdf_A;
  }
  Float connection(uint slot, uint /*sampleLow*/, uint member) const { return m_shared[slot].connections[member]; }

  // --- what paths from the lights bring ---
  SplatSums* splats = nullptr; // shared by the programs of all threads
  void addToSplat(uint number, WideCount n) {
    if (splats != nullptr)
      splats->add(number / 2, (std::uint64_t{n.high} << 32U) | n.low);
  }

  // --- what the library reports ---
  HostCounters counters;
  void reportTraversal(uint /*steps*/, bool cut) { counters.cutTraversal += cut ? 1U : 0U; }
  void reportLightWalk(uint /*levels*/) {}
  void reportClosestRay() { ++counters.raysClosest; }
  void reportShadowRay(bool traced) { counters.raysShadow += traced ? 1U : 0U; }
  void reportCappedPath() { ++counters.cappedPaths; }
  void reportInvalidPdf() { ++counters.invalidPdf; }
  void reportNonFinite() { ++counters.nonFinite; }
  void recordKind(uint kind, const Vec3& L) {
    if (allFinite(L))
      kinds[kind] += Vec3d(L);
  }
  std::array<Vec3d, kKindCount> kinds{}; // sums over all samples of this program

#include "lib/library.glsl"

  /// The start of sample number `sample` of a pixel.
  Path samplePath(uint x, uint y, std::uint64_t sample) {
    return cameraPath(y * m_frame.width + x, x, y, static_cast<uint>(sample), keyOf(sample));
  }

  /// The path from a light that goes with it, if any does; its splats are added up.
  void traceLightPath(uint x, uint y, std::uint64_t sample) {
    if (!tracesLights())
      return;
    kFromLight = true;
    Path path = lightPath(y * m_frame.width + x, static_cast<uint>(sample), keyOf(sample));
    if (mayBecomeCaustic(path.ray)) {
      while (Li(path)) {
      }
    }
    kFromLight = false;
  }

  /// Where path number i from the lights, sent on by specular surfaces alone, meets a diffuse one.
  std::optional<Photon> tracePhoton(uint i) {
    kFromLight = true;
    Path path = lightPath(i, 0, keyOf(0));
    bool goesOn = mayBecomeCaustic(path.ray);
    std::optional<Photon> photon;
    while (goesOn) {
      const Hit hit = traceClosest(path.ray);
      if (hit.triangle == kNoTriangle)
        break;
      const Vec3 wo = -path.ray.d;
      const Surface s = surfaceAt(hit, wo);
      const Float power = path.beta.x + path.beta.y + path.beta.z;
      if (s.m.bsdf == kBsdfDiffuse && path.bounce > 0 && isFinite(power))
        photon = Photon{Vec3f(s.p), guideBinOf(wo), static_cast<float>(power)};
      DirectLight direct;
      goesOn = isSpecular(s.m.bsdf) && extendPath(path, hit, direct);
    }
    kFromLight = false;
    return photon;
  }

  /// A sample's path, as far as one pixel alone can tell; where paths are shared it is left in the pixel's slot.
  Vec3 traceSample(uint x, uint y, std::uint64_t sample) {
    traceLightPath(x, y, sample);
    m_shared[m_slot].first = noFirstVertex();
    m_shared[m_slot].second = noSecondVertex();
    Path path = samplePath(x, y, sample);
    while (Li(path) || startAgain(path)) {
    }
    return finished(path);
  }

  /// Value of a sample whose path has ended, whatever it is.
  Vec3 valueOf(const Path& path) {
    return reusesPaths() ? unsharedValue(path, path.L, m_slot) : sampleValue(path);
  }
  /// The same as it counts: 0, and a fault, where it is not finite.
  Vec3 finished(const Path& path) {
    Vec3 L = finishedLight(path);
    if (!allFinite(L)) {
      ++counters.nonFinite;
      L = Vec3(0);
    }
    if (!reusesPaths())
      return L;
    const Vec3 value = unsharedValue(path, L, m_slot);
    m_shared[m_slot].light.L = L;
    if (path.reuse != kReuseShared)
      m_shared[m_slot].own = value;
    return value;
  }

  /// Samples summed in Float within groups of kSamplesPerGroup, the groups merged in double.
  struct OpenGroup {
    Vec3 mean{0};
    Vec3 deviations{0};
    uint count = 0;
  };
  void addToGroup(OpenGroup& group, const Vec3& L, bool last, PixelMoments& moments) {
    ++group.count;
    addSample(group.mean, group.deviations, Float(group.count), L);
    if (group.count == kSamplesPerGroup || last) {
      moments.merge({group.count, Vec3d(group.mean), Vec3d(group.deviations)});
      group = {};
    }
  }

  /// What path.comp does for one lane: samples [firstSample, firstSample + count) of a pixel.
  void samplePixel(uint x, uint y, std::uint64_t firstSample, std::uint64_t count, PixelMoments& moments) {
    OpenGroup group;
    for (std::uint64_t i = firstSample; i < firstSample + count; ++i)
      addToGroup(group, traceSample(x, y, i), i + 1 == firstSample + count, moments);
  }

  /// The same for all pixels of a block, with share_paths.comp: the block's column and row, `film` the whole image.
  void sampleBlock(uint column, uint row, std::uint64_t firstSample, std::uint64_t count, Film& film) {
    const auto x = [&](uint slot) { return column * kBlockEdge + columnInBlock(slot); };
    const auto y = [&](uint slot) { return row * kBlockEdge + rowInBlock(slot); };
    for (uint slot = 0; slot < kBlockPixels; ++slot) {
      m_shared[slot] = {};
      m_shared[slot].inImage = x(slot) < m_frame.width && y(slot) < m_frame.height;
    }
    const auto pixel = [&](uint slot) -> PixelMoments& {
      return film.pixels[std::size_t{y(slot)} * m_frame.width + x(slot)];
    };
    const auto eachSlot = [&](const auto& step) {
      for (m_slot = 0; m_slot < kBlockPixels; ++m_slot) {
        if (m_shared[m_slot].inImage)
          step(m_slot);
      }
      m_slot = 0;
    };
    if (!reusesPaths())
      return eachSlot([&](uint slot) { samplePixel(x(slot), y(slot), firstSample, count, pixel(slot)); });
    std::array<OpenGroup, kBlockPixels> groups;
    for (std::uint64_t i = firstSample; i < firstSample + count; ++i) {
      const uint sampleLow = static_cast<uint>(i);
      eachSlot([&](uint slot) { traceSample(x(slot), y(slot), i); });
      eachSlot([&](uint slot) {
        for (uint member = 0; member < kReuseEdge * kReuseEdge; ++member)
          connectPaths(slot, sampleLow, member);
      });
      eachSlot([&](uint slot) { balancePaths(slot, sampleLow); });
      eachSlot([&](uint slot) {
        addToGroup(groups[slot], sharedValue(slot, sampleLow), i + 1 == firstSample + count, pixel(slot));
      });
    }
  }

private:
  uint keyOf(std::uint64_t sample) const {
    return m_frame.seed ^ (static_cast<uint>(sample >> 32U) * 0x9E3779B9U);
  }
  static Float number(std::uint32_t bits) { return Float(std::bit_cast<float>(bits)); }
  static Vec3 vector(const Texel& t) { return Vec3(number(t[0]), number(t[1]), number(t[2])); }
  static Vec3 vector(const vec4& v) { return Vec3(v.x, v.y, v.z); }

  const PackedScene* m_scene;
  FrameConstants m_frame;
  std::array<Branch, kMaxSplitDepth> m_branches{};
  struct SharedPath {
    bool inImage = true;
    FirstVertex first{};
    SecondVertex second{};
    SharedLight light{};
    Vec3 own{0};
    std::array<Float, kBlockPixels> connections{};
  };
  std::array<SharedPath, kBlockPixels> m_shared{};
  uint m_slot = 0;
};

#include "host/make_program.inl"
#include "host/render_with.inl"
#include "host/replay_with.inl"

#undef INOUT
#undef OUT
#undef precise
#undef CONSTANT
