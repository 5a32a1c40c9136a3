#pragma once
// The Vulkan instance, device and queue that everything on the device shares.

#include "gpu/made_pipelines.h"

#include <vulkan/vulkan_raii.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vkpt::gpu {

struct DeviceInfo {
  std::string name;
  std::string driver; ///< driver's name and version text
  std::string type;   ///< "CPU", "DiscreteGpu", ...
  std::string api;    ///< "1.3.230"
};

/// What a program with a window needs; whose window it is, Vulkan need not know.
struct Presentation {
  std::vector<std::string> instanceExtensions; ///< of the window system, e.g. VK_KHR_xcb_surface
  /// Makes the window's surface; its error is an exception of its own.
  std::function<VkSurfaceKHR(VkInstance)> makeSurface;
};

struct ContextOptions {
  std::string device;                    ///< index or part of a name; empty: a discrete GPU, else any
  bool validation = false;               ///< turn the Khronos validation layer on; an error if it is missing
  std::filesystem::path pipelineCache{}; ///< folder of compiled pipelines; empty: none are kept
  std::optional<Presentation> presentation{}; ///< empty: no window
  /// Accesses beyond a buffer are defined, where the device can do that: no result depends on it.
  bool robustBufferAccess = false;
};

/// The devices that Vulkan shows, in its order, and which one `options.device` would choose.
std::vector<DeviceInfo> listDevices();
std::size_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& selector);

/// Owns instance, device and one queue: it computes, and with a window it draws and presents too. Throws
/// DeviceError, also for every failed Vulkan call.
class Context {
public:
  explicit Context(const ContextOptions& options = {});

  [[nodiscard]] const vk::raii::Device& device() const { return m_device; }
  [[nodiscard]] vk::Instance instance() const { return *m_instance; }
  [[nodiscard]] const vk::raii::PhysicalDevice& physicalDevice() const { return m_physical; }
  [[nodiscard]] const vk::raii::Queue& queue() const { return m_queue; }
  [[nodiscard]] std::uint32_t queueFamily() const { return m_queueFamily; }
  /// Null without a window.
  [[nodiscard]] vk::SurfaceKHR surface() const { return *m_surface; }
  [[nodiscard]] const vk::PhysicalDeviceLimits& limits() const { return m_properties.limits; }
  [[nodiscard]] const vk::PhysicalDeviceMemoryProperties& memory() const { return m_memory; }
  [[nodiscard]] const DeviceInfo& info() const { return m_info; }
  [[nodiscard]] const vk::PhysicalDeviceProperties& properties() const { return m_properties; }
  [[nodiscard]] const std::filesystem::path& pipelineCache() const { return m_pipelineCache; }
  [[nodiscard]] MadePipelines& madePipelines() const { return *m_madePipelines; }
  /// Bytes of the device's largest memory heap.
  [[nodiscard]] std::uint64_t largestHeap() const;
  /// Messages of the validation layer so far; tests demand none.
  [[nodiscard]] std::uint64_t validationMessages() const { return *m_validationMessages; }

  /// Records commands, submits them and waits until they are done.
  void execute(const std::function<void(const vk::raii::CommandBuffer&)>& record) const;

private:
  vk::raii::Context m_loader;
  std::shared_ptr<std::atomic<std::uint64_t>> m_validationMessages;
  vk::raii::Instance m_instance = nullptr;
  vk::raii::DebugUtilsMessengerEXT m_messenger = nullptr;
  vk::raii::SurfaceKHR m_surface = nullptr;
  vk::raii::PhysicalDevice m_physical = nullptr;
  vk::raii::Device m_device = nullptr;
  std::uint32_t m_queueFamily = 0;
  vk::raii::Queue m_queue = nullptr;
  vk::raii::CommandPool m_pool = nullptr;
  vk::raii::CommandBuffers m_commands = nullptr;
  vk::raii::Fence m_fence = nullptr;
  vk::PhysicalDeviceProperties m_properties;
  vk::PhysicalDeviceMemoryProperties m_memory;
  DeviceInfo m_info;
  std::filesystem::path m_pipelineCache;
  std::unique_ptr<MadePipelines> m_madePipelines = std::make_unique<MadePipelines>();
};

} // namespace vkpt::gpu
