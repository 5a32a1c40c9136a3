// Known mistakes, one line each: X(id, Name, what is broken). A test build (VKPT_MUTATIONS) can switch one
// on; tests/scenes shows that each of the first list is noticed, tests/bsdf of the second, tests/stability of
// the third. In every other build MUTATE is its right side and nothing else.
#ifndef VKPT_SHARED_MUTATIONS_H
#define VKPT_SHARED_MUTATIONS_H

#define VKPT_MUTATIONS_LIST(X)                                                                               \
  X(1, SurfaceCosineDropped, "direct light without the surface's cosine")                                    \
  X(2, LightCosineDropped, "direct light without the light's cosine")                                        \
  X(3, InversePiDropped, "the diffuse BSDF is the albedo, not albedo / pi")                                  \
  X(4, DistanceNotSquared, "direct light falls with r, not r^2")                                             \
  X(5, SurvivalNotDivided, "survivors of roulette don't stand for those that ended")                         \
  X(6, LightAreaDropped, "the light's density lacks 1 / area")                                               \
  X(7, LightChoiceDropped, "the light's density lacks the probability of its choice")                        \
  X(8, AliasIgnored, "a row of the light table never takes its alias")                                       \
  X(9, EmissionTwice, "emission counts again after a light-sampled vertex")                                  \
  X(10, BackEmits, "emitters emit from their back when hit")                                                 \
  X(11, BackSampled, "emitters emit from their back when sampled")                                           \
  X(12, UniformHemisphere, "directions uniform over the hemisphere, weighted as if by cosine")               \
  X(13, TriangleWarp, "points of a triangle without the square root: too many at one corner")                \
  X(14, AlwaysReflects, "glass never refracts")                                                              \
  X(15, NeverReflects, "glass refracts whenever it can")                                                     \
  X(16, FresnelOnePolarisation, "glass reflects as if light were polarised")                                 \
  X(17, EtaInverted, "glass and air change places in Snell's law")                                           \
  X(18, GlassAlwaysEntered, "glass is entered from inside too")                                              \
  X(19, ConductorAbsorptionDropped, "metal without the imaginary part of its index")                         \
  X(20, MirrorWeightDropped, "a mirror reflects all light")                                                  \
  X(21, OcclusionIgnored, "shadow rays never meet anything")                                                 \
  X(22, OffsetDropped, "rays start on the surface itself")                                                   \
  X(23, OffsetInward, "rays start on the wrong side of the surface")                                         \
  X(24, RouletteCapped, "survival capped at one half without the division by it")                            \
  X(25, LightBlockReused, "light and BSDF of a vertex share their random numbers")                           \
  X(26, NextLightBlockReused, "a vertex's BSDF and the next one's light share their random numbers")         \
  X(27, SampleIgnored, "every sample of a pixel has the same random numbers")                                \
  X(28, BounceLimitOffByOne, "one bounce more than the limit")                                               \
  X(29, BackgroundTwice, "the background counts twice")                                                      \
  X(30, ThroughputDropped, "emission without the path's throughput")                                         \
  X(31, DirectThroughputDropped, "direct light without the path's throughput")                               \
  X(32, PixelNotJittered, "every sample through the pixel's centre")                                         \
  X(33, ImageFlipped, "the image upside down")                                                               \
  X(34, CarriedEmitLost, "a path that goes on in the next dispatch counts all emission")                     \
  X(35, CarriedThroughputLost, "a path that goes on in the next dispatch starts with full throughput")       \
  X(36, TooFewSamplesInMean, "the film's running mean divides by one more than it holds")                    \
  X(37, DeviationsFromOldMean, "the film's deviations use the old mean twice")                               \
  X(38, MergeMeanUnweighted, "groups of samples merge as if equally large")                                  \
  X(39, MergeBetweenDropped, "merged deviations lack the spread between the groups")                         \
  X(40, MergeLowDropped, "the film's pairs of floats lose their low half")                                   \
  X(41, MisWeightDropped, "light sampling and BSDF sampling both count in full")                             \
  X(42, MisSamplesIgnored, "BSDF sampling is weighted as if there were one light sample")                    \
  X(43, LightSamplesNotAveraged, "several light samples add up")                                             \
  X(44, PhongNormalisation, "the density of Phong's lobe is normalised as its value is")                     \
  X(45, BackScatters, "one-sided surfaces scatter on their back too")                                        \
  X(46, PointFalloffDropped, "point lights don't fall off")                                                  \
  X(47, EnvironmentAliasIgnored, "a row of the environment's table never takes its alias")                   \
  X(48, EnvironmentSineDropped, "directions within a texel uniform in the angle, not the solid angle")       \
  X(49, TextureFlipped, "textures upside down")                                                              \
  X(50, FilterSignDropped, "samples in a filter's negative lobes count as positive")                         \
  X(51, SplitUnweighted, "the reflected branch of a split vertex counts in full")                            \
  X(52, BranchKeyShared, "branches of a split path share their random numbers")                              \
  X(53, UnwantedKindsCount, "kinds of light path that were left out count")                                  \
  X(54, TransmissionIsReflection, "specular transmission is taken for reflection")                           \
  X(55, CarriedBranchLost, "a path that goes on in the next dispatch forgets its waiting branches")          \
  X(56, CarriedPdfLost, "a path that goes on in the next dispatch forgets the density of its direction")     \
  X(57, CarriedHistoryLost, "a path that goes on in the next dispatch forgets its kind")                     \
  X(91, ReplicatesAlike, "the replicates of a point set share their scrambling")                             \
  X(92, CausticsTwice, "what paths from the lights find counts in full where the eye's paths find it too")   \
  X(93, AxisCosineDropped, "splats far from the image's centre are as bright as in the centre")              \
  X(94, ShadingAdjointDropped, "light is scattered by shading normals as radiance is")                       \
  X(95, IndexAdjointDropped, "light is refracted without the square of the index")                           \
  X(96, IrreversibleJoined, "light that leaves by another rule than it came is joined to the eye")           \
  X(97, SplatCarryLost, "sums of splats have 32 bits")                                                       \
  X(98, RepeatsAlike, "the paths of a sample share their random numbers")                                    \
  X(99, RepeatsNotAveraged, "several paths of a sample add up")                                              \
  X(112, AllottedUnweighted, "paths that are allotted to a side of glass count alike")                       \
  X(100, CarriedRepeatLost, "a sample that goes on in the next dispatch begins again with its first path")   \
  X(101, TreeShareDropped, "the light tree's children are as probable as each other")                        \
  X(102, TreeWeighedByPower, "light found by chance is weighed as if lights were chosen by power")           \
  X(103, CarriedTableLost, "a path that goes on in the next dispatch has forgotten where it comes from")     \
  X(113, TableShareDropped, "the nodes that a table of lights chooses from are as probable as each other")   \
  X(114, TableAliasIgnored, "rows of a table of lights always keep themselves")                              \
  X(104, ReuseGeometryDropped, "paths are shared without the cosine of their second vertex")                 \
  X(105, ReuseThroughWalls, "paths are shared through whatever is in between")                               \
  X(106, ReuseBlockedCounts,                                                                                 \
    "pixels that don't see a shared vertex count among those that could have found it")                      \
  X(107, ReuseWeighsByEye, "caustics on shared paths are weighed by each pixel's own density")               \
  X(108, CarriedReuseLost, "a path that goes on in the next dispatch has forgotten that it is shared")       \
  X(109, GuideDensityDropped, "guided directions are weighted as if the BSDF had drawn them")                \
  X(110, GuideAliasIgnored, "a row of a histogram of directions never takes its alias")                      \
  X(111, GuideWeighedByBoth, "light sampling and guided directions are weighted by different densities")

// Those that tests/bsdf notices: by samples counted against their density, and by closed forms.
#define VKPT_SAMPLING_MUTATIONS_LIST(X)                                                                      \
  X(58, ReflectionJacobianDropped, "rough metal's density is that of the facets, not of directions")         \
  X(59, MaskingDropped, "microfacets neither mask nor shadow each other")                                    \
  X(60, RefractionJacobianWrong, "rough glass refracts with a Jacobian that lacks the index")                \
  X(61, RoughGlassAlwaysEntered, "rough glass is entered from inside too")                                   \
  X(62, AllNormalsVisible, "facets are sampled as if seen from above")                                       \
  X(63, SlopeNotSolved, "Beckmann's visible slopes are the first guess")                                     \
  X(64, CoatFresnelDropped, "the coat of Nori's microfacet reflects all light")

// Naive versions of what is written with care for float: tests/stability shows that the cases notice each.
#define VKPT_STABILITY_MUTATIONS_LIST(X)                                                                     \
  X(65, RefractionUnclamped, "the root of Snell's law is not kept from going below 0")                       \
  X(66, EqualIndicesUnguarded, "Fresnel's equations as they stand for equal indices")                        \
  X(67, PhongByPower, "Phong's lobe as a power of a float's cosine")                                         \
  X(68, PhongSineCancels, "the sine of a sampled lobe from 1 - cos^2")                                       \
  X(69, UnitMayBeOne, "32 random bits over 2^32, which rounds to 1")                                         \
  X(70, WeightBySquares, "the power heuristic by squares of densities")                                      \
  X(71, FacetSineCancels, "the angle of a facet from 1 - cos^2")                                             \
  X(72, BlackGoesOn, "roulette divides a throughput of 0 by a probability of 0")                             \
  X(73, AlbedoClamped, "albedos above 1 are clamped")                                                        \
  X(74, DepthCapped, "paths end after 64 bounces")                                                           \
  X(75, SampleHighIgnored, "random numbers repeat after 2^32 samples")                                       \
  X(76, PlainSums, "the film sums in floats")                                                                \
  X(77, PixelKeyIsSum, "pixel and sample are added up to seed the random numbers")                           \
  X(78, RefractionScaled, "radiance is scaled by the square of an index whenever it is refracted")           \
  X(79, FaultsHidden, "a sample that is not finite is dropped in silence")                                   \
  X(87, RefractionCancels, "the cosine beyond a boundary from 1 - sin^2")                                    \
  X(88, PhongLogCancels, "the logarithm of a number close to 1 as the driver has it")

// Naive geometry, which tests/stability notices; lib/naive.glsl has the longer ones.
#define VKPT_GEOMETRY_MUTATIONS_LIST(X)                                                                      \
  X(80, NaiveGeometry, "the next two at once: what stability costs is measured against them")                \
  X(81, LeakyTriangle, "Moeller and Trumbore's triangle test, with their epsilon")                           \
  X(82, AbsoluteOffset, "rays start 1e-4 off the surface, whatever the scene's size")                        \
  X(83, FrisvadFrame, "frames divide by 1 + n.z")                                                            \
  X(84, InfiniteInverse, "a component of 0 has an infinite inverse in the slab test")                        \
  X(86, TiesAtRandom, "of two triangles at one distance the later one is hit")                               \
  X(89, BoxesMissedAside, "boxes are met where the direction leads, triangles where the basis does")         \
  X(90, HitsUpToTheEdge, "points of triangles are so close to edges that rounding puts them beyond")

#ifdef VKPT_MUTATIONS
layout(constant_id = 127) const uint kMutation = 0u;
#define VKPT_MUTATION_ID(id, Name, what) const uint kMutation##Name = id;
VKPT_MUTATIONS_LIST(VKPT_MUTATION_ID)
VKPT_SAMPLING_MUTATIONS_LIST(VKPT_MUTATION_ID)
VKPT_STABILITY_MUTATIONS_LIST(VKPT_MUTATION_ID)
VKPT_GEOMETRY_MUTATIONS_LIST(VKPT_MUTATION_ID)
#undef VKPT_MUTATION_ID
#define MUTATE(Name, right, wrong) (kMutation == kMutation##Name ? (wrong) : (right))
#else
#define MUTATE(Name, right, wrong) (right)
#endif

#endif
