// Structs and constants that the host and the shaders share; the only definition of each layout.
// Only uint, float and vec4, in an order that std140 and std430 lay out as C++ does.
#ifndef VKPT_SHARED_STRUCTS_H
#define VKPT_SHARED_STRUCTS_H

#include "shared/effects.h"

#ifdef __cplusplus
#include <cstdint>
namespace vkpt::shared {
using uint = std::uint32_t;
struct alignas(16) vec4 {
  float x, y, z, w;
};
#define VKPT_CONSTANT inline constexpr
#else
#define VKPT_CONSTANT const
#endif

// --- bindings of descriptor set 0 ---
VKPT_CONSTANT uint kBindingFrame = 0u;        // uniform FrameConstants
VKPT_CONSTANT uint kBindingNodes = 1u;        // texel buffer: 8 texels a node
VKPT_CONSTANT uint kBindingTriangles = 2u;    // texel buffer: 3 texels a triangle, in BVH order
VKPT_CONSTANT uint kBindingNormals = 3u;      // texel buffer: 3 texels a triangle, in BVH order
VKPT_CONSTANT uint kBindingMaterials = 4u;    // texel buffer: 6 texels a material
VKPT_CONSTANT uint kBindingLights = 5u;       // texel buffer: 4 texels a light
VKPT_CONSTANT uint kBindingPaths = 6u;        // storage: saved path states, plane by plane
VKPT_CONSTANT uint kBindingCounters = 7u;     // storage: Counters
VKPT_CONSTANT uint kBindingFilm = 8u;         // storage[kFilmPlanes]: the film, one buffer a plane
VKPT_CONSTANT uint kBindingSlots = 9u;        // storage: slots with samples still to do, two lists in turn
VKPT_CONSTANT uint kBindingUvs = 10u;         // texel buffer: 2 texels a triangle, in BVH order
VKPT_CONSTANT uint kBindingTextures = 11u;    // texel buffer: a texel for each texture, then their pixels
VKPT_CONSTANT uint kBindingEnvironment = 12u; // texel buffer: 2 texels for each of the map's
VKPT_CONSTANT uint kBindingKinds = 13u;       // storage[kKindCount]: an image of each kind of light path
VKPT_CONSTANT uint kBindingReplicates = 14u;  // texel buffer[3], by channel: a pixel's mean in each replicate
VKPT_CONSTANT uint kBindingSplats = 15u; // texel buffer of single numbers: what paths from the lights bring
VKPT_CONSTANT uint kBindingLightNodes = 16u;  // texel buffer: 3 texels a node of the light tree
VKPT_CONSTANT uint kBindingReuse = 17u;       // texel buffer: kTexelsPerSharedPath a sample and slot
VKPT_CONSTANT uint kBindingConnections = 18u; // texel buffer of single numbers: densities of connections
VKPT_CONSTANT uint kBindingGuide = 19u;       // texel buffer of single numbers: src/device/guide.h
VKPT_CONSTANT uint kBindingLightGrid = 20u;   // texel buffer of single numbers: src/device/light_grid.h
VKPT_CONSTANT uint kBindingCount = 21u;

// --- texels a record takes ---
VKPT_CONSTANT uint kTexelsPerNode = 8u;
VKPT_CONSTANT uint kTexelsPerTriangle = 3u;
VKPT_CONSTANT uint kTexelsPerMaterial = 6u;
VKPT_CONSTANT uint kTexelsPerLight = 4u;
VKPT_CONSTANT uint kTexelsPerLightNode = 3u;
VKPT_CONSTANT uint kTexelsPerUv = 2u;
VKPT_CONSTANT uint kTexelsPerEnvironmentTexel = 2u;
VKPT_CONSTANT uint kTexelsPerSharedPath = 7u; // what a sample's path leaves for others, and behind it
VKPT_CONSTANT uint kTexelsPerBegunPath = 5u;  // what it goes on with; and kVertexPlanes with a light tree
VKPT_CONSTANT uint kPixelsPerTexel = 2u;      // of a texture: RGB in half floats

// --- choices among bins by alias tables in whole numbers: src/device/alias_bins.h ---
VKPT_CONSTANT uint kAliasUnits = 65536u; // of all bins together

// --- guided directions: lib/guide.glsl ---
VKPT_CONSTANT uint kGuideEdge = 16u; // bins of directions on a side of a square
VKPT_CONSTANT uint kGuideBits = 8u;
VKPT_CONSTANT uint kGuideBins = kGuideEdge * kGuideEdge; // 2^kGuideBits
VKPT_CONSTANT uint kGuideShareInverse = 4u;              // one of so many directions is the guide's
VKPT_CONSTANT uint kGuideShareBelow = 0xFFFFFFFFu / kGuideShareInverse + 1u; // 2^32 over it
VKPT_CONSTANT uint kNoGuide = 0xFFFFFFFFu;
// The number of a cube of a grid with `edge` cubes along it, a multiple of 4: sixteen that lie together share
// a cache line.
#ifdef __cplusplus
constexpr
#endif
    uint
    guideCube(uint x, uint y, uint z, uint edge) {
  uint block = ((z >> 1u) * (edge >> 1u) + (y >> 1u)) * (edge >> 2u) + (x >> 2u);
  return (block << 4u) | ((z & 1u) << 3u) | ((y & 1u) << 2u) | (x & 3u);
}

// --- the grid of lights: lib/light_tree.glsl ---
VKPT_CONSTANT uint kLightGridEdge = 8u; // cubes along it
VKPT_CONSTANT uint kLightGridCubes = kLightGridEdge * kLightGridEdge * kLightGridEdge;
VKPT_CONSTANT uint kLightGridSides = 7u; // tables of a cube: by the axis that normals lie closest to, or any
VKPT_CONSTANT uint kAnySide = 6u;
VKPT_CONSTANT uint kMostLightTableBits = 10u; // a table chooses from 2^10 nodes of the light tree at most

// --- specialisation constants beside the effects (ids 0..63) ---
VKPT_CONSTANT uint kConstantStackDepth = 64u;
VKPT_CONSTANT uint kConstantRouletteMode = 65u;
VKPT_CONSTANT uint kConstantFilterShape = 66u;
VKPT_CONSTANT uint kConstantPrimaryView = 67u; // of path.comp built with VKPT_PRIMARY
VKPT_CONSTANT uint kConstantSampler = 68u;
VKPT_CONSTANT uint kConstantFromLight = 69u;
VKPT_CONSTANT uint kConstantByLightTree = 70u;
VKPT_CONSTANT uint kConstantReuseEdge = 71u; // of a square of pixels that share paths; 1: none do
VKPT_CONSTANT uint kConstantShareStep = 72u; // of share_paths.comp
VKPT_CONSTANT uint kConstantByLightTables = 73u;
VKPT_CONSTANT uint kConstantLightTableBits = 74u;
VKPT_CONSTANT uint kConstantBelowLightTables = 75u;

VKPT_CONSTANT uint kStepConnect = 0u;
VKPT_CONSTANT uint kStepBalance = 1u;
VKPT_CONSTANT uint kStepAddUp = 2u;

VKPT_CONSTANT uint kPrimaryBaseColour = 0u;
VKPT_CONSTANT uint kPrimaryNormals = 1u;

VKPT_CONSTANT uint kRouletteAlbedo = 0u;
VKPT_CONSTANT uint kRouletteThroughput = 1u;
VKPT_CONSTANT uint kRouletteConstant = 2u;

// --- materials: kBsdfDiffuse, ..., the values of vkpt::BsdfType: ids of the effects ---
#define VKPT_ID(id, Name, name, what) VKPT_CONSTANT uint kIdOf##Name = id;
VKPT_EFFECTS(VKPT_ID)
#undef VKPT_ID
#define VKPT_NUMBER(Name, Type) VKPT_CONSTANT uint kBsdf##Type = kIdOf##Name;
VKPT_BSDFS(VKPT_NUMBER)
#undef VKPT_NUMBER

// Flags of a material.
VKPT_CONSTANT uint kMaterialOneSided = 1u;
VKPT_CONSTANT uint kMaterialBeckmann = 2u; // else GGX

// --- lights: in place of a triangle's number ---
VKPT_CONSTANT uint kLightPoint = 0xFFFFFFFEu;
VKPT_CONSTANT uint kLightDirectional = 0xFFFFFFFDu;
VKPT_CONSTANT uint kLightEnvironment = 0xFFFFFFFCu; // from here on no triangle
VKPT_CONSTANT uint kLightLeaf = 0x80000000u;        // of a node of the light tree: below it is one light
VKPT_CONSTANT uint kMaxLightTreeDepth = 64u;        // levels below the root

// --- how emitters are found: the values of vkpt::LightStrategy ---
VKPT_CONSTANT uint kStrategyNee = 0u;
VKPT_CONSTANT uint kStrategyBsdf = 1u;
VKPT_CONSTANT uint kStrategyMis = 2u;

// --- random numbers: the values of vkpt::Sampler ---
VKPT_CONSTANT uint kSamplerIndependent = 0u;
VKPT_CONSTANT uint kSamplerSobol = 1u;
// Groups of kSamplesPerGroup samples belong in turn to so many point sets, each scrambled by itself: what
// they differ by tells the error.
VKPT_CONSTANT uint kReplicates = 4u;

// --- kinds of light path: the values of vkpt::PathKind ---
VKPT_CONSTANT uint kKindEmission = 0u;
VKPT_CONSTANT uint kKindDirect = 1u;
VKPT_CONSTANT uint kKindCaustic = 2u;
VKPT_CONSTANT uint kKindIndirect = 3u;
VKPT_CONSTANT uint kKindIndirectCaustic = 4u;
VKPT_CONSTANT uint kKindSpecular = 5u;
VKPT_CONSTANT uint kKindCount = 6u;

// --- reconstruction filters: the values of vkpt::PixelFilter::Shape ---
VKPT_CONSTANT uint kFilterBox = 0u;
VKPT_CONSTANT uint kFilterTent = 1u;
VKPT_CONSTANT uint kFilterGaussian = 2u;
VKPT_CONSTANT uint kFilterMitchell = 3u;
VKPT_CONSTANT uint kFilterBins = 64u; // of equal probability

// --- the unit of work ---
VKPT_CONSTANT uint kBlockEdge = 8u; // pixels are worked on in blocks of 8x8, one work-group each
VKPT_CONSTANT uint kBlockPixels = 64u;
VKPT_CONSTANT uint kStripes = 64u; // neighbouring work-groups lie in different stripes of the image
VKPT_CONSTANT uint kSamplesPerGroup =
    16u;                                // samples summed in float before they join the film's pairs of floats
VKPT_CONSTANT uint kBounceCap = 10000u; // ends paths trapped by total internal reflection; counted

// lavapipe ends ALL loops of a subgroup together, in silence, after 65 535 iterations
// (LP_MAX_TGSI_LOOP_ITERATIONS). A traversal step is one iteration of a loop with two loops inside, of at
// most kNodesPerStep and kLeafTriangles iterations; a vertex starts only below kStepBudget, it counts as a
// step, and its two traversals take at most kMaxTraversalSteps each. With a light tree come as many walks
// through it as light samples, and one more. So the limit is never met: (1950 + 1 + 2 * 3050) * (1 + 3 + 4) +
// 17 * 65 < 65535.
VKPT_CONSTANT uint kMaxStackDepth = 48u; // levels of the tree, and one
VKPT_CONSTANT uint kNodesPerStep = 3u;
VKPT_CONSTANT uint kLeafTriangles = 4u; // vkpt::kMaxLeafTriangles
VKPT_CONSTANT uint kStepBudget = 1950u;
VKPT_CONSTANT uint kMaxTraversalSteps = 3050u; // with several light samples their shadow rays share them
VKPT_CONSTANT uint kMaxLightSamples = 16u;
VKPT_CONSTANT uint kMaxSpecularSamples = 16u;
VKPT_CONSTANT uint kMaxSplitDepth = 16u; // a path's branches are told apart by 16 bits

// --- the film: planes of one 32-bit value a pixel ---
VKPT_CONSTANT uint kFilmCount = 0u;      // uint: samples, those of the open group included
VKPT_CONSTANT uint kFilmMean = 1u;       // float pairs (high, low) x RGB, of the closed groups
VKPT_CONSTANT uint kFilmDeviations = 7u; // the same for the sums of squared deviations
VKPT_CONSTANT uint kFilmOpenMean = 13u;  // float x RGB: the open group, fewer than kSamplesPerGroup samples
VKPT_CONSTANT uint kFilmOpenDeviations = 16u;
VKPT_CONSTANT uint kFilmPlanes = 19u; // 76 bytes a pixel

// Images of the kinds of light path, one buffer each, of planes of one float a pixel.
VKPT_CONSTANT uint kKindOpen = 0u;   // RGB: sum over the open group
VKPT_CONSTANT uint kKindClosed = 3u; // float pairs (high, low) x RGB: sum over the closed groups
VKPT_CONSTANT uint kKindPlanes = 9u; // 36 bytes a pixel

// What paths from the lights bring to a pixel, by channel the sum and the sum of squares: integers of 64
// bits, low half first, so that no order of adding changes them.
VKPT_CONSTANT uint kSplatNumbers = 12u; // 48 bytes a pixel
// Behind the pixels' the sums of all that a part of the paths has brought, by part and channel: what they
// differ by tells the error of the image's mean, to which a path brings several splats. By the path's own
// pixel.
VKPT_CONSTANT uint kSplatParts = 64u;
VKPT_CONSTANT uint kSpecularBoxes = 4u; // that hold the specular surfaces between them

VKPT_CONSTANT uint kPathPlanes = 6u;   // uvec4 planes of a saved path state: 96 bytes a slot
VKPT_CONSTANT uint kBranchPlanes = 3u; // and of each branch that waits: 48 bytes
VKPT_CONSTANT uint kVertexPlanes = 2u; // and of the vertex before, where there is a light tree: 32 bytes

// --- faults: the values of vkpt::FaultCause ---
VKPT_CONSTANT uint kFaultNonFinite = 0u;    // a sample that is not finite
VKPT_CONSTANT uint kFaultCutTraversal = 1u; // a ray that took too many steps
VKPT_CONSTANT uint kFaultInvalidPdf = 2u;   // a sampled direction of no finite weight or density
VKPT_CONSTANT uint kFaultCauses = 3u;
VKPT_CONSTANT uint kMaxFaultRecords = 64u; // of a dispatch

struct FaultRecord {
  uint pixel;
  uint sampleLow;
  uint bounce;
  uint cause;
};

// --- what one dispatch reports ---
struct Counters {
  uint unfinished; // slots with samples still to do
  uint raysClosest;
  uint raysShadow;
  uint cappedPaths;
  uint carriedPaths; // paths saved for the next dispatch
  uint nonFinite;
  uint cutTraversal;
  uint stackOverflow;
  uint invalidPdf;
  uint faultRecords; // how many faults wanted to be recorded
  uint unused0;
  uint unused1;
  FaultRecord records[kMaxFaultRecords];
};

// --- what stays the same over a render: uniform buffer ---
struct FrameConstants {
  vec4 eye;       // camera position in local coordinates
  vec4 upperLeft; // direction to the image plane's top left corner (plane at distance 1)
  vec4 right;     // over the image's width, at distance 1
  vec4 down;      // over the image's height
  vec4 forward;   // the camera's axis, unit; w: the image's area at distance 1
  vec4 background;
  uint width;
  uint height;
  uint seed;
  uint lightCount;
  uint maxBounces;
  uint rouletteAfter;
  uint blocksX; // blocks in a row of the image
  uint blocksPerStripe;
  uint lightSamples;
  uint splitDepth;
  uint pathKinds;               // bit k: paths of kind k are wanted
  uint deadHistories;           // bit h: no path of history h (lib/kinds.glsl) can become one that is wanted
  float survival;               // of --roulette constant
  float environmentProbability; // with which light sampling chooses the environment
  uint environmentWidth;
  uint environmentHeight;
  uint lightStrategy;
  uint tracesLights;      // 1: with every sample goes a path from a light
  float splatUnits;       // of a splat's sum, one unit of radiance
  float splatSquareUnits; // of its sum of squares, one unit of squared radiance
  float lightPower;       // of all lights that light sampling knows, over pi, summed over the channels
  uint specularSamples;   // paths of a sample whose first surface is specular
  uint environmentLeaf;   // of the light tree
  uint guideGridEdge;     // cubes along it; 0: nothing was learned
  float sharedEyePdf_A;   // in place of the eye's density at the first vertex, where paths are shared
  vec4 lightGridLower;    // corner of the grid of lights; w: cubes per metre, 0: there is none
  vec4 guideLower;        // corner of the grid of guided directions; w: cubes per metre
  vec4 specularLower[kSpecularBoxes]; // a box more than there are lies far away
  vec4 specularUpper[kSpecularBoxes];
  vec4 filterShape;                        // radius, and what the shape needs: lib/filter.glsl
  vec4 filterEdges[kFilterBins / 4u + 1u]; // edges of the bins, in pixels from the centre
};

// --- what a dispatch works on: push constants ---
struct Dispatch {
  uint firstBlock; // of the tile, in striped order
  uint blockCount;
  uint slotCount;   // blockCount * kBlockPixels
  uint firstSample; // low 32 bits of the sample index
  uint firstSampleHigh;
  uint sampleCount; // samples a pixel in this batch; never straddles a group
  uint fresh;       // 1: start the batch; 0: go on with the saved states of the listed slots
  uint listed;      // how many slots are listed, if not fresh
  uint packs;       // 1: a subgroup stops when a quarter of its lanes have run out of work
  uint listTurn;    // 0 or 1: the list this dispatch writes; it reads the other one
};

// --- drawing the film into a window: display.comp ---
VKPT_CONSTANT uint kDisplayFilm = 0u;   // storage[kFilmPlanes]
VKPT_CONSTANT uint kDisplayPixels = 1u; // storage: the picture, 8 bits a channel, a uint a pixel
VKPT_CONSTANT uint kDisplaySplats = 2u; // texel buffer: the film's kBindingSplats

struct DisplayJob { // push constants
  uint filmWidth;
  uint filmHeight;
  uint width; // of the picture; a pixel of the film is stretched over it
  uint height;
  uint tonemap;          // lib/display.glsl
  uint redLast;          // 1: bytes B G R A, 0: R G B A
  uint shows;            // kShowsMean, ...
  float scale;           // of radiance
  float splatUnit;       // radiance that a unit of the splats' sums stands for; 0: there are none
  float splatSquareUnit; // and of the squared standard error that of their squares
};
VKPT_CONSTANT uint kShowsMean = 0u;
VKPT_CONSTANT uint kShowsStandardError = 1u;

#ifdef __cplusplus
} // namespace vkpt::shared
#endif
#endif
