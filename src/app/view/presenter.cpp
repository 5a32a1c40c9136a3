#include "app/view/presenter.h"

#include "core/error.h"

#include <fmt/format.h>

#include <limits>

namespace vkpt {
namespace {

using Access = vk::AccessFlagBits;
using Layout = vk::ImageLayout;

const vk::ImageSubresourceRange kWhole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);

} // namespace

Presenter::Presenter(const gpu::Context& context, Window& window)
    : m_context(context), m_window(window), m_swapchain(context), m_picture(context, m_swapchain.isBgr()),
      m_panel(context, window, m_swapchain),
      m_pool(context.device(), {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, context.queueFamily()}),
      m_commands(context.device(), {*m_pool, vk::CommandBufferLevel::ePrimary, 1}),
      m_drawn(context.device(), {vk::FenceCreateFlagBits::eSignaled}) {}

Presenter::~Presenter() {
  try {
    m_context.device().waitIdle();
  } catch (const vk::SystemError&) {
    // A lost device is idle.
  }
}

void Presenter::finish() const { m_context.device().waitIdle(); }

void Presenter::bind(const Integrator& integrator) { m_picture.bind(integrator); }

bool Presenter::makeRoom() {
  const Vec2i size = m_window.surfaceSize();
  if (size.x <= 0 || size.y <= 0)
    return false;
  if (!m_swapchain.isStale() && m_swapchain.size() == size)
    return true;
  finish();
  m_swapchain.resize(size);
  if (m_swapchain.isStale())
    return false;
  if (m_picture.size() != m_swapchain.size())
    m_picture.resize(m_swapchain.size());
  m_panel.resize(m_swapchain);
  return true;
}

void Presenter::record(const SwapchainFrame& frame, Vec2i filmSize, const DisplaySettings& display,
                       Shows shows) const {
  const vk::raii::CommandBuffer& commands = m_commands[0];
  commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
  m_picture.draw(commands, filmSize, display, shows);
  const vk::ImageMemoryBarrier toCopy({}, Access::eTransferWrite, Layout::eUndefined,
                                      Layout::eTransferDstOptimal, VK_QUEUE_FAMILY_IGNORED,
                                      VK_QUEUE_FAMILY_IGNORED, frame.image, kWhole);
  commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eTransfer, {}, {},
                           {}, toCopy);
  const vk::Extent3D extent(static_cast<std::uint32_t>(m_picture.size().x),
                            static_cast<std::uint32_t>(m_picture.size().y), 1);
  const vk::BufferImageCopy copy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {0, 0, 0}, extent);
  commands.copyBufferToImage(m_picture.pixels(), frame.image, Layout::eTransferDstOptimal, copy);
  m_panel.draw(commands, frame);
  commands.end();
}

bool Presenter::show(Vec2i filmSize, const DisplaySettings& display, Shows shows,
                     const std::function<void()>& widgets) {
  try {
    m_panel.begin();
    widgets();
    m_panel.end();
    if (!makeRoom())
      return false;
    while (m_context.device().waitForFences(*m_drawn, VK_TRUE, std::numeric_limits<std::uint64_t>::max()) ==
           vk::Result::eTimeout) {
    }
    const auto frame = m_swapchain.acquire();
    if (!frame)
      return false;
    record(*frame, filmSize, display, shows);
    m_context.device().resetFences(*m_drawn);
    const vk::PipelineStageFlags waitsAt = vk::PipelineStageFlagBits::eTransfer;
    m_context.queue().submit(vk::SubmitInfo(frame->acquired, waitsAt, *m_commands[0], frame->drawn),
                             *m_drawn);
    m_swapchain.present(*frame);
    return true;
  } catch (const vk::SystemError& e) {
    throw DeviceError(fmt::format("{}: {}", m_context.info().name, e.what()));
  }
}

} // namespace vkpt
