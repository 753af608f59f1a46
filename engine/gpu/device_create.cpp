#include <algorithm>
#include <cstring>

#include "base/log.hpp"
#include "pipeline_cache.hpp"
#include "sanitizer.hpp"
#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

std::vector<VkExtensionProperties> instanceExtensions(const char* layer) {
  std::uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(layer, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data());
  return extensions;
}

bool contains(const std::vector<VkExtensionProperties>& extensions, const std::string& name) {
  return std::any_of(extensions.begin(), extensions.end(), [&](const auto& e) { return name == e.extensionName; });
}

bool hasLayer(const char* name) {
  std::uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(), [&](const auto& l) { return std::strcmp(l.layerName, name) == 0; });
}

Result<void> createInstance(Device::State& state, const DeviceOptions& options) {
  if (volkInitialize() != VK_SUCCESS)
    return failed("Vulkan: libvulkan.so.1 is not there; install the package libvulkan1");
  if (!vkEnumerateInstanceVersion || volkGetInstanceVersion() < VK_API_VERSION_1_3)
    return failed("Vulkan: the loader is older than 1.3");
  if (options.validation && !hasLayer(kValidationLayer))
    return failed(std::string("validation: the layer ") + kValidationLayer +
                  " is not there; install the package vulkan-validationlayers");

  const auto available = instanceExtensions(nullptr);
  std::vector<const char*> extensions;
  for (const std::string& name : options.instanceExtensions) {
    if (!contains(available, name)) return failed("Vulkan: the instance extension " + name + " is not there");
    extensions.push_back(name.c_str());
  }
  state.debugNames = contains(available, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  if (options.validation) {
    const auto ofLayer = instanceExtensions(kValidationLayer);
    if (!state.debugNames && !contains(ofLayer, VK_EXT_DEBUG_UTILS_EXTENSION_NAME))
      return failed("validation: no VK_EXT_debug_utils to hear it by");
    state.debugNames = true;
    if (!contains(ofLayer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME))
      return failed("validation: the layer has no synchronization validation (VK_EXT_validation_features)");
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
  }
  if (state.debugNames) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = application.pEngineName = "Tyndall";
  application.apiVersion = VK_API_VERSION_1_3;
  const VkValidationFeatureEnableEXT enable = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
  VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT, nullptr, 1, &enable};
  VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(state.validation);
  messenger.pNext = &features;  // hears the creation and the end of the instance too
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  if (options.validation)
    info.pNext = &messenger, info.enabledLayerCount = 1, info.ppEnabledLayerNames = &kValidationLayer;
  if (const VkResult result = vkCreateInstance(&info, nullptr, &state.instance)) {
    state.instance = VK_NULL_HANDLE;
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) return failed(kNoDriver);
    return vkFailed("Vulkan: no instance", result);
  }
  // Not volkLoadDevice: its pointers belong to one device, and tests open a second one with other layers.
  volkLoadInstance(state.instance);
  keepDriversLoaded();
  if (options.validation) {
    messenger.pNext = nullptr;
    if (const VkResult result = vkCreateDebugUtilsMessengerEXT(state.instance, &messenger, nullptr, &state.messenger))
      return vkFailed("validation: no messenger", result);
  }
  return {};
}

void fillInfo(Device::State& state) {
  VkPhysicalDeviceMaintenance4Properties maintenance{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES};
  VkPhysicalDevicePushDescriptorPropertiesKHR push{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PUSH_DESCRIPTOR_PROPERTIES_KHR,
                                                   &maintenance};
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES, &push};
  VkPhysicalDeviceSubgroupProperties subgroup{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES, &driver};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &subgroup};
  vkGetPhysicalDeviceProperties2(state.physical, &properties);
  DeviceInfo& info = state.info;
  info.name = properties.properties.deviceName;
  info.driver = std::string(driver.driverName) + (driver.driverInfo[0] ? " " : "") + driver.driverInfo;
  info.isCpu = properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  info.subgroupSize = subgroup.subgroupSize;
  info.limits = properties.properties.limits;
  info.maxPushDescriptors = push.maxPushDescriptors;
  info.timestampPeriodNs = static_cast<double>(info.limits.timestampPeriod);
  state.maxBufferBytes = maintenance.maxBufferSize;

  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(state.physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(state.physical, &count, families.data());
  state.timestampBits = families[state.family].timestampValidBits;
  openPipelineCache(state, properties.properties);
}

Result<void> createLogicalDevice(Device::State& state, const DeviceOptions& options) {
  Features offered, enabled;
  vkGetPhysicalDeviceFeatures2(state.physical, &offered.core);
  for (const auto& [name, flag] : enabled.required()) *flag = VK_TRUE;
  const auto from = offered.optional(), to = enabled.optional();
  for (std::size_t i = 0; i < to.size(); ++i) *to[i].flag = *from[i].flag;
  state.anisotropy = enabled.core.features.samplerAnisotropy;
  state.geometryShader = enabled.core.features.geometryShader;

  const float priority = 1;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = state.family, queue.queueCount = 1, queue.pQueuePriorities = &priority;
  std::vector<const char*> extensions{VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
  if (options.window) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &enabled.core};
  info.queueCreateInfoCount = 1, info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  if (const VkResult result = vkCreateDevice(state.physical, &info, nullptr, &state.device)) {
    state.device = VK_NULL_HANDLE;
    return vkFailed("Vulkan: the device cannot be opened", result);
  }
  vkGetDeviceQueue(state.device, state.family, 0, &state.queue);
  return {};
}

Result<void> createFrameObjects(Device::State& state) {
  VkSemaphoreTypeCreateInfo type{VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO, nullptr, VK_SEMAPHORE_TYPE_TIMELINE, 0};
  VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, &type};
  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, nullptr,
                               VK_COMMAND_POOL_CREATE_TRANSIENT_BIT, state.family};
  VkCommandPoolCreateInfo oneShots = pool;
  oneShots.flags |= VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;  // each is begun anew, again and again
  VkResult result = vkCreateSemaphore(state.device, &semaphore, nullptr, &state.timeline);
  if (!result) result = vkCreateCommandPool(state.device, &oneShots, nullptr, &state.oneShotPool);
  for (auto& slot : state.slots) {
    if (!result) result = vkCreateCommandPool(state.device, &pool, nullptr, &slot.pool);
    VkCommandBufferAllocateInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, nullptr, slot.pool,
                                         VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
    if (!result) result = vkAllocateCommandBuffers(state.device, &commands, &slot.commands);
  }
  if (result) return vkFailed("Vulkan: no frame objects", result);
  return {};
}

}  // namespace

Result<std::unique_ptr<Device>> Device::create(const DeviceOptions& options) {
  std::unique_ptr<Device> device(new Device);
  device->state_ = std::make_unique<State>();
  State& state = *device->state_;
  if (auto made = createInstance(state, options); !made) return made.error();
  auto choice = chooseDevice(state.instance, options);
  if (!choice) return choice.error();
  state.physical = choice->physical;
  state.family = choice->family;
  if (auto made = createLogicalDevice(state, options); !made) return made.error();
  state.allocator = std::make_unique<Allocator>(state.physical, state.device);
  fillInfo(state);
  if (auto made = createFrameObjects(state); !made) return made.error();
  state.name(VK_OBJECT_TYPE_SEMAPHORE, state.timeline, "frames");
  log::debug("device: " + state.info.name + ", " + state.info.driver);
  return device;
}

Result<std::unique_ptr<Device>> Device::createSibling() const {
  std::unique_ptr<Device> device(new Device);
  device->state_ = std::make_unique<State>();
  State& state = *device->state_;
  state.instance = state_->instance;
  state.sibling = true;
  state.physical = state_->physical;
  state.family = state_->family;
  state.debugNames = state_->debugNames;
  if (auto made = createLogicalDevice(state, {}); !made) return made.error();
  state.allocator = std::make_unique<Allocator>(state.physical, state.device);
  state.info = state_->info;
  state.maxBufferBytes = state_->maxBufferBytes;
  if (auto made = createFrameObjects(state); !made) return made.error();
  return device;
}

}  // namespace tyndall::gpu
