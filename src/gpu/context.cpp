#include "gpu/context.h"

#include "core/error.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <span>

namespace vkpt::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";
constexpr std::uint32_t kApiVersion = VK_API_VERSION_1_2;

VKAPI_ATTR VkBool32 VKAPI_CALL onValidationMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                   VkDebugUtilsMessageTypeFlagsEXT,
                                                   const VkDebugUtilsMessengerCallbackDataEXT* data,
                                                   void* counter) {
  ++*static_cast<std::atomic<std::uint64_t>*>(counter);
  spdlog::error("Vulkan validation: {}", data->pMessage);
  return VK_FALSE;
}

vk::DebugUtilsMessengerCreateInfoEXT messengerInfo(std::atomic<std::uint64_t>* counter) {
  using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
  using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
  return {{},
          Severity::eWarning | Severity::eError,
          Type::eValidation | Type::ePerformance,
          onValidationMessage,
          counter};
}

vk::raii::Instance makeInstance(const vk::raii::Context& loader, bool validation,
                                std::atomic<std::uint64_t>* counter,
                                std::span<const std::string> windowExtensions) {
  std::vector<const char*> layers;
  std::vector<const char*> extensions;
  for (const auto& extension : windowExtensions)
    extensions.push_back(extension.c_str());
  if (validation) {
    const auto available = loader.enumerateInstanceLayerProperties();
    const bool present = std::ranges::any_of(available, [](const vk::LayerProperties& layer) {
      return std::strcmp(layer.layerName, kValidationLayer) == 0;
    });
    if (!present)
      throw DeviceError("the Vulkan validation layer is missing; install vulkan-validationlayers");
    layers.push_back(kValidationLayer);
    extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  }
  const vk::ApplicationInfo application("vkpt", 1, "vkpt", 1, kApiVersion);
  vk::InstanceCreateInfo info({}, &application, layers, extensions);
  const auto messenger = messengerInfo(counter);
  if (validation)
    info.pNext = &messenger;
  return {loader, info};
}

DeviceInfo describe(const vk::raii::PhysicalDevice& device) {
  const auto chain =
      device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
  const auto& p = chain.get<vk::PhysicalDeviceProperties2>().properties;
  const auto& d = chain.get<vk::PhysicalDeviceDriverProperties>();
  return {p.deviceName.data(), fmt::format("{} {}", d.driverName.data(), d.driverInfo.data()),
          vk::to_string(p.deviceType),
          fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(p.apiVersion), VK_API_VERSION_MINOR(p.apiVersion),
                      VK_API_VERSION_PATCH(p.apiVersion))};
}

std::vector<DeviceInfo> describeAll(const std::vector<vk::raii::PhysicalDevice>& devices) {
  std::vector<DeviceInfo> infos;
  for (const auto& d : devices)
    infos.push_back(describe(d));
  return infos;
}

/// One that computes; with a surface, one that draws and presents to it as well.
std::uint32_t chooseQueueFamily(const vk::raii::PhysicalDevice& device, vk::SurfaceKHR surface) {
  using Flag = vk::QueueFlagBits;
  const vk::QueueFlags wanted = surface ? Flag::eCompute | Flag::eGraphics : vk::QueueFlags(Flag::eCompute);
  const auto families = device.getQueueFamilyProperties();
  for (std::uint32_t i = 0; i < families.size(); ++i) {
    if ((families[i].queueFlags & wanted) == wanted &&
        (!surface || device.getSurfaceSupportKHR(i, surface) == VK_TRUE))
      return i;
  }
  throw DeviceError(surface ? "the Vulkan device has no queue that computes, draws and presents to this "
                              "window; choose another with --device"
                            : "the Vulkan device has no compute queue; choose another with --device");
}

std::vector<const char*> deviceExtensions(const vk::raii::PhysicalDevice& device, bool presents) {
  if (!presents)
    return {};
  const auto available = device.enumerateDeviceExtensionProperties();
  const bool present = std::ranges::any_of(available, [](const vk::ExtensionProperties& extension) {
    return std::strcmp(extension.extensionName, VK_KHR_SWAPCHAIN_EXTENSION_NAME) == 0;
  });
  if (!present)
    throw DeviceError("the Vulkan device can't present to a window; choose another with --device");
  return {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
}

void requireSubgroupArithmetic(const vk::raii::PhysicalDevice& device) {
  const auto chain =
      device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>();
  const auto& subgroup = chain.get<vk::PhysicalDeviceSubgroupProperties>();
  const bool ok = (subgroup.supportedStages & vk::ShaderStageFlagBits::eCompute) &&
                  (subgroup.supportedOperations & vk::SubgroupFeatureFlagBits::eArithmetic);
  if (!ok)
    throw DeviceError("the Vulkan device lacks subgroup arithmetic; choose another with --device");
}

} // namespace

std::vector<DeviceInfo> listDevices() {
  try {
    const vk::raii::Context loader;
    const vk::raii::Instance instance = makeInstance(loader, false, nullptr, {});
    return describeAll(vk::raii::PhysicalDevices(instance));
  } catch (const std::exception& e) {
    // A loader without drivers fails in one of several ways; for the user they are one.
    spdlog::debug("listing Vulkan devices: {}", e.what());
    return {};
  }
}

std::size_t chooseDevice(const std::vector<DeviceInfo>& devices, const std::string& selector) {
  if (devices.empty()) {
    throw DeviceError("no Vulkan device; install a driver, or mesa-vulkan-drivers for software Vulkan");
  }
  if (selector.empty()) {
    for (const char* type : {"DiscreteGpu", "IntegratedGpu", "VirtualGpu"}) {
      const auto it = std::ranges::find(devices, type, &DeviceInfo::type);
      if (it != devices.end())
        return static_cast<std::size_t>(it - devices.begin());
    }
    return 0;
  }
  std::size_t index = 0;
  const char* end = selector.data() + selector.size();
  const auto parsed = std::from_chars(selector.data(), end, index);
  if (parsed.ec == std::errc{} && parsed.ptr == end && index < devices.size())
    return index;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (devices[i].name.find(selector) != std::string::npos)
      return i;
  }
  std::string names;
  for (std::size_t i = 0; i < devices.size(); ++i)
    names += fmt::format(" {} '{}'", i, devices[i].name);
  throw DeviceError(fmt::format("--device '{}': no such Vulkan device; there is{}", selector, names));
}

Context::Context(const ContextOptions& options) try
    : m_validationMessages(std::make_shared<std::atomic<std::uint64_t>>(0)) {
  const Presentation window = options.presentation.value_or(Presentation());
  m_instance =
      makeInstance(m_loader, options.validation, m_validationMessages.get(), window.instanceExtensions);
  if (options.validation) {
    m_messenger = vk::raii::DebugUtilsMessengerEXT(m_instance, messengerInfo(m_validationMessages.get()));
  }
  if (options.presentation)
    m_surface = vk::raii::SurfaceKHR(m_instance, window.makeSurface(*m_instance));
  vk::raii::PhysicalDevices devices(m_instance);
  const auto infos = describeAll(devices);
  const std::size_t chosen = chooseDevice(infos, options.device);
  m_physical = std::move(devices[chosen]);
  m_info = infos[chosen];
  requireSubgroupArithmetic(m_physical);
  m_properties = m_physical.getProperties();
  m_pipelineCache = options.pipelineCache;
  m_memory = m_physical.getMemoryProperties();

  m_queueFamily = chooseQueueFamily(m_physical, *m_surface);
  const float priority = 1.0F;
  const vk::DeviceQueueCreateInfo queue({}, m_queueFamily, 1, &priority);
  const auto extensions = deviceExtensions(m_physical, options.presentation.has_value());
  vk::PhysicalDeviceFeatures features;
  features.robustBufferAccess = options.robustBufferAccess && m_physical.getFeatures().robustBufferAccess;
  m_device = vk::raii::Device(m_physical, vk::DeviceCreateInfo({}, queue, {}, extensions, &features));
  m_queue = vk::raii::Queue(m_device, m_queueFamily, 0);
  m_pool =
      vk::raii::CommandPool(m_device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, m_queueFamily});
  m_commands = vk::raii::CommandBuffers(m_device, {*m_pool, vk::CommandBufferLevel::ePrimary, 1});
  m_fence = vk::raii::Fence(m_device, vk::FenceCreateInfo{});
} catch (const vk::IncompatibleDriverError&) {
  throw DeviceError("no Vulkan device; install a driver, or mesa-vulkan-drivers for software Vulkan");
} catch (const vk::SystemError& e) {
  throw DeviceError(fmt::format("Vulkan: {}", e.what()));
}

std::uint64_t Context::largestHeap() const {
  std::uint64_t largest = 0;
  for (std::uint32_t i = 0; i < m_memory.memoryHeapCount; ++i)
    largest = std::max<std::uint64_t>(largest, m_memory.memoryHeaps[i].size);
  return largest;
}

void Context::execute(const std::function<void(const vk::raii::CommandBuffer&)>& record) const {
  // Finite waits, so that a debugger or a log can show where a hung device stands.
  constexpr std::uint64_t kWaitNanoseconds = 1'000'000'000;
  try {
    const vk::raii::CommandBuffer& commands = m_commands[0];
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record(commands);
    commands.end();
    m_queue.submit(vk::SubmitInfo({}, {}, *commands), *m_fence);
    while (m_device.waitForFences(*m_fence, VK_TRUE, kWaitNanoseconds) == vk::Result::eTimeout) {
      spdlog::debug("still waiting for the device");
    }
    m_device.resetFences(*m_fence);
  } catch (const vk::SystemError& e) {
    throw DeviceError(fmt::format("{}: {}", m_info.name, e.what()));
  }
}

} // namespace vkpt::gpu
