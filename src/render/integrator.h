#pragma once
// Runs the kernels: one unit of work is a tile times a batch of frames.

#include "device/device_scene.h"
#include "device/effects.h"
#include "gpu/compute_pipeline.h"
#include "render/device_film.h"
#include "render/device_kinds.h"
#include "render/device_replicates.h"
#include "render/device_reuse.h"
#include "render/device_splats.h"
#include "shared/structs.h"
#include "spirv.h"

#include <functional>
#include <optional>

namespace vkpt {

/// Sums over a run of what the dispatches report; see interface.md for the JSON names.
struct RunCounters {
  std::uint64_t samples = 0;
  std::uint64_t raysClosest = 0;
  std::uint64_t raysShadow = 0;
  std::uint64_t cappedPaths = 0;  ///< ended by the far bounce cap (trapped by total internal reflection)
  std::uint64_t carriedPaths = 0; ///< saved in one dispatch, gone on with in the next
  std::uint64_t nonFinite = 0;
  std::uint64_t cutTraversal = 0;
  std::uint64_t stackOverflow = 0;
  std::uint64_t invalidPdf = 0;
  std::uint64_t dispatches = 0;
  [[nodiscard]] std::uint64_t faults() const { return nonFinite + cutTraversal + stackOverflow + invalidPdf; }
};

enum class FaultCause : std::uint32_t {
  NonFinite = shared::kFaultNonFinite,
  CutTraversal = shared::kFaultCutTraversal,
  InvalidPdf = shared::kFaultInvalidPdf,
};

/// Where a fault happened: enough to trace the path again.
struct Fault {
  int x = 0;
  int y = 0;
  std::uint64_t sample = 0;
  std::uint32_t bounce = 0;
  FaultCause cause = FaultCause::NonFinite;
};

/// Blocks of 8x8 pixels in striped order (device_memory.glsl: pixelOfSlot).
struct Tile {
  std::uint32_t firstBlock = 0;
  std::uint32_t blockCount = 0;
};

/// The shipped ones, or other builds of them.
struct KernelShaders {
  std::span<const std::uint32_t> path = spirv::kPath;
  DeviceReuse::Shaders reuse{spirv::kFirstVertices, spirv::kSharePaths};
};

struct IntegratorSettings {
  EstimatorSettings estimator;
  int width = 512;
  int height = 512;
  std::uint32_t seed = 0;
  KernelShaders shaders;
  gpu::SpecialisationMap extraConstants; ///< of other builds of the shaders
};

/// The film as it lies in device memory, of which film() makes the host's: that takes longer than reading it.
struct RawFilm {
  int width = 0;
  int height = 0;
  FilmPlanes planes;
  ReplicateMeans replicates;
  SplatSums splats;
  SplatScale splatScale;
  [[nodiscard]] Film film() const;
};

class Integrator {
public:
  Integrator(const gpu::Context& context, const DeviceScene& scene, const Scene& source,
             const EffectSet& effects, const IntegratorSettings& settings);

  /// Blocks there are; a few at the end may lie outside the image.
  [[nodiscard]] std::uint32_t blockCount() const;
  /// Traces samples [firstSample, firstSample + count) of every pixel of the tile and commits them to the
  /// film. They lie within one group of kSamplesPerGroup. Returns the samples taken.
  /// `between` is called between its dispatches, of which long paths need many.
  std::uint64_t renderTile(const Tile& tile, std::uint64_t firstSample, std::uint32_t count,
                           const std::function<void()>& between = {});
  /// Makes the driver compile what it compiles at the first use.
  void warmUp();
  void clear();
  /// As if made anew with this seed, but compiled.
  void restart(std::uint32_t seed);
  /// As if made anew for the camera of `source` and this size, but compiled. `source` is else what it was.
  /// Throws UsageError as the constructor does, and leaves all as it was where the camera has no direction.
  void restart(const Scene& source, int width, int height);

  [[nodiscard]] RawFilm rawFilm() const;
  [[nodiscard]] Film film() const { return rawFilm().film(); }
  /// One pixel of it.
  [[nodiscard]] PixelMoments pixel(int x, int y) const;
  [[nodiscard]] const DeviceFilm& deviceFilm() const { return m_film; }
  [[nodiscard]] const DeviceSplats& deviceSplats() const { return m_splats; }
  /// Radiance that a unit of the splats' sums stands for in the film as it is, and squared standard error
  /// that one of their squares does; 0 without any.
  [[nodiscard]] SplatScale splatUnits() const;
  /// Mean radiance of each kind of light path, by pixel; empty unless settings.estimator.kindImages.
  [[nodiscard]] std::vector<std::vector<Vec3d>> kindImages(const Film& film) const;
  [[nodiscard]] const RunCounters& counters() const { return m_counters; }
  /// The first kMaxFaultRecords faults.
  [[nodiscard]] const std::vector<Fault>& faults() const { return m_faults; }
  [[nodiscard]] const IntegratorSettings& settings() const { return m_settings; }
  [[nodiscard]] std::uint64_t filmBytes() const {
    return m_film.bytes() + m_kinds.bytes() + m_replicates.bytes() + m_splats.bytes();
  }

private:
  [[nodiscard]] std::uint64_t pixelsOf(const Tile& tile) const;
  [[nodiscard]] SplatScale splatScale() const {
    return {m_constants.splatUnits, m_constants.splatSquareUnits};
  }
  void reserveSlots(std::uint32_t slots);
  void renderPart(const Tile& part, std::uint64_t firstSample, std::uint32_t count,
                  const std::function<void()>& between);
  void forget();
  /// Work-groups for every block in x, as given in y and z.
  void dispatch(vk::Pipeline pipeline, const shared::Dispatch& job, std::uint32_t y = 1,
                std::uint32_t z = 1) const;
  /// All of a unit's paths, from the lights or from the eye.
  void tracePaths(const gpu::ComputePipeline& pipeline, shared::Dispatch job,
                  const std::function<void()>& between);
  shared::Counters traceOnce(vk::Pipeline pipeline, const shared::Dispatch& job, std::uint32_t y = 1,
                             std::uint32_t z = 1);
  /// First vertices of all paths of a batch, where they are shared.
  void beginPaths(shared::Dispatch job, const std::function<void()>& between);
  /// What the pixels share of a batch whose paths have ended.
  void sharePaths(const shared::Dispatch& job, const std::function<void()>& between);
  void keepFaults(const shared::Counters& counters, const shared::Dispatch& job);

  const gpu::Context& m_context;
  IntegratorSettings m_settings;
  bool m_lightTree; ///< states hold what it needs
  shared::FrameConstants m_constants{};
  gpu::BindingSet m_bindings;
  gpu::ComputePipeline m_path;
  std::optional<gpu::ComputePipeline> m_lightPath; ///< where paths from the lights are traced
  gpu::ComputePipeline m_commit;
  gpu::Buffer m_constantsBuffer;
  gpu::Buffer m_countersBuffer;
  gpu::Buffer m_paths;
  gpu::Buffer m_slotLists;
  std::uint32_t m_slots = 0;
  DeviceFilm m_film;
  DeviceKinds m_kinds;
  DeviceReplicates m_replicates;
  DeviceSplats m_splats;
  DeviceReuse m_reuse;
  std::uint64_t m_lightPaths = 0; ///< whose splats are in the film
  RunCounters m_counters;
  std::vector<Fault> m_faults;
};

} // namespace vkpt
