#include "app/view/film_picture.h"

#include "app/view/view_shaders.h"

#include <array>
#include <cmath>

namespace vkpt {
namespace {

using vk::DescriptorType;

constexpr std::uint32_t kGroup = 64; // of display.comp
constexpr auto kLayout = std::to_array<gpu::BindingLayout>({
    {shared::kDisplayFilm, DescriptorType::eStorageBuffer, shared::kFilmPlanes},
    {shared::kDisplayPixels, DescriptorType::eStorageBuffer},
    {shared::kDisplaySplats, DescriptorType::eStorageTexelBuffer},
});

std::uint32_t whole(int x) { return static_cast<std::uint32_t>(x); }

} // namespace

FilmPicture::FilmPicture(const gpu::Context& context, bool bgr)
    : m_context(context), m_bindings(context, kLayout, sizeof(shared::DisplayJob)),
      m_pipeline(context, spirv::kDisplay, m_bindings, {}), m_bgr(bgr) {}

void FilmPicture::resize(Vec2i size) {
  m_size = size;
  m_pixels =
      gpu::Buffer(m_context, "picture", std::uint64_t{whole(size.x)} * whole(size.y) * sizeof(std::uint32_t),
                  vk::BufferUsageFlagBits::eStorageBuffer, gpu::MemoryKind::Device);
  m_pixels.fillZero(m_context);
  m_bindings.bind(m_context, shared::kDisplayPixels, m_pixels, DescriptorType::eStorageBuffer);
}

void FilmPicture::bind(const Integrator& integrator) {
  m_integrator = &integrator;
  integrator.deviceFilm().bind(m_context, m_bindings, shared::kDisplayFilm);
  integrator.deviceSplats().bind(m_context, m_bindings, shared::kDisplaySplats);
}

void FilmPicture::draw(const vk::raii::CommandBuffer& commands, Vec2i filmSize,
                       const DisplaySettings& display, Shows shows) const {
  using Access = vk::AccessFlagBits;
  const shared::DisplayJob job{whole(filmSize.x),
                               whole(filmSize.y),
                               whole(m_size.x),
                               whole(m_size.y),
                               static_cast<std::uint32_t>(display.tonemap),
                               m_bgr ? 1U : 0U,
                               static_cast<std::uint32_t>(shows),
                               static_cast<float>(std::exp2(display.exposureStops)),
                               m_integrator->splatUnits().units,
                               m_integrator->splatUnits().squareUnits};
  // What the last picture was copied from may be written, and what the film's kernels wrote may be read.
  const vk::MemoryBarrier before(Access::eShaderWrite | Access::eTransferWrite,
                                 Access::eShaderRead | Access::eShaderWrite);
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader | vk::PipelineStageFlagBits::eTransfer,
                           vk::PipelineStageFlagBits::eComputeShader, {}, before, {}, {});
  commands.bindPipeline(vk::PipelineBindPoint::eCompute, m_pipeline.handle());
  commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, m_bindings.pipelineLayout(), 0,
                              m_bindings.set(), {});
  commands.pushConstants<shared::DisplayJob>(m_bindings.pipelineLayout(), vk::ShaderStageFlagBits::eCompute,
                                             0, job);
  commands.dispatch((job.width * job.height + kGroup - 1) / kGroup, 1, 1);
  // The picture is copied next; the film is written next.
  const vk::MemoryBarrier after(Access::eShaderWrite, Access::eTransferRead);
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader,
                           vk::PipelineStageFlagBits::eTransfer | vk::PipelineStageFlagBits::eComputeShader,
                           {}, after, {}, {});
}

} // namespace vkpt
