#pragma once
// The film as a picture in device memory: display.comp, straight from the film's planes.

#include "core/math.h"
#include "film/image.h"
#include "render/integrator.h"

namespace vkpt {

enum class Shows : std::uint32_t {
  Mean = shared::kShowsMean,
  StandardError = shared::kShowsStandardError,
};

class FilmPicture {
public:
  /// bgr: the order of the picture's bytes.
  FilmPicture(const gpu::Context& context, bool bgr);

  /// Of the picture; what it showed is gone. The device must be idle.
  void resize(Vec2i size);
  [[nodiscard]] Vec2i size() const { return m_size; }
  /// Draws its film from now on. The device must be idle.
  void bind(const Integrator& integrator);
  /// Records the drawing of the film, stretched over the picture, and makes it ready to be copied from.
  void draw(const vk::raii::CommandBuffer& commands, Vec2i filmSize, const DisplaySettings& display,
            Shows shows) const;
  [[nodiscard]] vk::Buffer pixels() const { return m_pixels.handle(); }

private:
  const gpu::Context& m_context;
  gpu::BindingSet m_bindings;
  gpu::ComputePipeline m_pipeline;
  gpu::Buffer m_pixels;
  const Integrator* m_integrator = nullptr;
  Vec2i m_size{0};
  bool m_bgr;
};

} // namespace vkpt
