#include "app/view/panel_renderer.h"

#include "core/error.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_vulkan.h>
#include <imgui.h>

namespace vkpt {
namespace {

void check(VkResult result) {
  if (result != VK_SUCCESS)
    throw DeviceError("the panel could not be drawn: " + vk::to_string(static_cast<vk::Result>(result)));
}

/// Draws over what is there; begins where a copy into the image ends, and ends where it can be presented.
vk::raii::RenderPass makePass(const gpu::Context& context, vk::Format format) {
  const vk::AttachmentDescription image(
      {}, format, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad, vk::AttachmentStoreOp::eStore,
      vk::AttachmentLoadOp::eDontCare, vk::AttachmentStoreOp::eDontCare, vk::ImageLayout::eTransferDstOptimal,
      vk::ImageLayout::ePresentSrcKHR);
  const vk::AttachmentReference reference(0, vk::ImageLayout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
  using Access = vk::AccessFlagBits;
  const vk::SubpassDependency afterCopy(VK_SUBPASS_EXTERNAL, 0, vk::PipelineStageFlagBits::eTransfer,
                                        vk::PipelineStageFlagBits::eColorAttachmentOutput,
                                        Access::eTransferWrite,
                                        Access::eColorAttachmentRead | Access::eColorAttachmentWrite);
  return {context.device(), vk::RenderPassCreateInfo({}, image, subpass, afterCopy)};
}

} // namespace

PanelRenderer::PanelRenderer(const gpu::Context& context, const Window& window, const Swapchain& swapchain)
    : m_context(context), m_window(window), m_pass(makePass(context, swapchain.format())) {
  constexpr std::uint32_t kSets = 8; // the font needs one
  const vk::DescriptorPoolSize fonts(vk::DescriptorType::eCombinedImageSampler, kSets);
  m_pool = vk::raii::DescriptorPool(context.device(),
                                    {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, kSets, fonts});
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr; // leaves no file behind
  ImGui_ImplGlfw_InitForVulkan(window.handle(), true);
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = context.instance();
  info.PhysicalDevice = *context.physicalDevice();
  info.Device = *context.device();
  info.QueueFamily = context.queueFamily();
  info.Queue = *context.queue();
  info.DescriptorPool = *m_pool;
  info.MinImageCount = 2;
  info.ImageCount = std::max(2U, swapchain.imageCount());
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = check;
  ImGui_ImplVulkan_Init(&info, *m_pass);
  makeFont();
}

PanelRenderer::~PanelRenderer() {
  ImGui_ImplVulkan_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void PanelRenderer::makeFont() {
  constexpr float kFontSize = 13.0F; // of the built-in font, where it is sharp
  m_scale = m_window.textScale();
  ImFontConfig font;
  font.SizePixels = kFontSize * m_scale;
  ImGui::GetIO().Fonts->AddFontDefault(&font);
  m_context.execute(
      [](const vk::raii::CommandBuffer& commands) { ImGui_ImplVulkan_CreateFontsTexture(*commands); });
  ImGui_ImplVulkan_DestroyFontUploadObjects();
}

void PanelRenderer::setStyle() {
  constexpr float kRounding = 4.0F;
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  style.WindowRounding = style.FrameRounding = style.GrabRounding = kRounding;
  style.ScaleAllSizes(m_window.textScale());
  ImGui::GetStyle() = style;
  ImGui::GetIO().FontGlobalScale = m_window.textScale() / m_scale; // another monitor's density
}

void PanelRenderer::resize(const Swapchain& swapchain) {
  m_size = swapchain.size();
  m_framebuffers.clear();
  for (const auto& view : swapchain.views()) {
    const vk::ImageView attachment = *view;
    m_framebuffers.emplace_back(m_context.device(),
                                vk::FramebufferCreateInfo({}, *m_pass, attachment,
                                                          static_cast<std::uint32_t>(m_size.x),
                                                          static_cast<std::uint32_t>(m_size.y), 1));
  }
  setStyle();
}

void PanelRenderer::begin() {
  ImGui_ImplVulkan_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void PanelRenderer::end() { ImGui::Render(); }

void PanelRenderer::draw(const vk::raii::CommandBuffer& commands, const SwapchainFrame& frame) const {
  const vk::Rect2D area({0, 0}, {static_cast<std::uint32_t>(m_size.x), static_cast<std::uint32_t>(m_size.y)});
  commands.beginRenderPass({*m_pass, *m_framebuffers[frame.index], area}, vk::SubpassContents::eInline);
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), *commands);
  commands.endRenderPass();
}

} // namespace vkpt
