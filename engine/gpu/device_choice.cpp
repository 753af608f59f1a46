#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

#include "state.hpp"
#include "vk_text.hpp"

namespace tyndall::gpu {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

int rank(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 4;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 3;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return 1;
    default: return 0;
  }
}

struct Candidate {
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties{};
  std::uint32_t family = 0;
  std::vector<std::string> lacks;
};

Candidate examine(VkPhysicalDevice physical, const DeviceOptions& options) {
  Candidate candidate{physical};
  vkGetPhysicalDeviceProperties(physical, &candidate.properties);
  const std::uint32_t version = candidate.properties.apiVersion;
  if (version < VK_API_VERSION_1_3) {
    candidate.lacks.push_back("Vulkan 1.3 (it has " + std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
                              std::to_string(VK_API_VERSION_MINOR(version)) + ")");
    return candidate;  // the feature structs below are 1.3's
  }
  Features features;
  vkGetPhysicalDeviceFeatures2(physical, &features.core);
  for (const auto& [name, flag] : features.required())
    if (!*flag) candidate.lacks.push_back(name);
  std::vector<const char*> extensions{VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
  if (options.window) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  for (const char* name : extensions)
    if (!hasExtension(physical, name)) candidate.lacks.push_back(name);

  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  const auto family = std::find_if(families.begin(), families.end(), [](const auto& f) {
    return (f.queueFlags & VK_QUEUE_GRAPHICS_BIT) && (f.queueFlags & VK_QUEUE_COMPUTE_BIT);
  });
  if (family == families.end())
    candidate.lacks.push_back("a queue for graphics and compute");
  else
    candidate.family = static_cast<std::uint32_t>(family - families.begin());
  return candidate;
}

std::string describe(const std::vector<Candidate>& candidates) {
  std::string list;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    list += (i ? ", " : "") + std::to_string(i) + " '" + candidates[i].properties.deviceName + "'";
    for (std::size_t k = 0; k < candidates[i].lacks.size(); ++k)
      list += (k ? ", " : " (lacks ") + candidates[i].lacks[k];
    if (!candidates[i].lacks.empty()) list += ")";
  }
  return list;
}

}  // namespace

Features::Features() { core.pNext = &v11, v11.pNext = &v12, v12.pNext = &v13; }

std::vector<Features::Named> Features::required() {
  VkPhysicalDeviceFeatures& f = core.features;
  return {{"depthClamp", &f.depthClamp},
          {"independentBlend", &f.independentBlend},
          {"shaderStorageImageExtendedFormats", &f.shaderStorageImageExtendedFormats},
          {"fragmentStoresAndAtomics", &f.fragmentStoresAndAtomics},
          {"timelineSemaphore", &v12.timelineSemaphore},
          {"scalarBlockLayout", &v12.scalarBlockLayout},
          {"dynamicRendering", &v13.dynamicRendering},
          {"synchronization2", &v13.synchronization2},
          // What glslang makes of plain GLSL for Vulkan 1.3 needs these (spec-constant group sizes, discard).
          {"maintenance4", &v13.maintenance4},
          {"shaderTerminateInvocation", &v13.shaderTerminateInvocation},
          {"shaderDemoteToHelperInvocation", &v13.shaderDemoteToHelperInvocation}};
}

std::vector<Features::Named> Features::optional() {
  VkPhysicalDeviceFeatures& f = core.features;
  return {{"samplerAnisotropy", &f.samplerAnisotropy},
          {"geometryShader", &f.geometryShader},
          {"multiDrawIndirect", &f.multiDrawIndirect},
          {"drawIndirectFirstInstance", &f.drawIndirectFirstInstance},
          {"vertexPipelineStoresAndAtomics", &f.vertexPipelineStoresAndAtomics},
          {"shaderStorageImageWriteWithoutFormat", &f.shaderStorageImageWriteWithoutFormat},
          {"shaderImageGatherExtended", &f.shaderImageGatherExtended},
          {"shaderClipDistance", &f.shaderClipDistance},
          {"shaderFloat64", &f.shaderFloat64},
          {"shaderInt64", &f.shaderInt64},
          {"shaderInt16", &f.shaderInt16},
          {"storageBuffer16BitAccess", &v11.storageBuffer16BitAccess},
          {"shaderDrawParameters", &v11.shaderDrawParameters},
          {"shaderFloat16", &v12.shaderFloat16},
          {"samplerFilterMinmax", &v12.samplerFilterMinmax},
          {"subgroupSizeControl", &v13.subgroupSizeControl},
          {"computeFullSubgroups", &v13.computeFullSubgroups}};
}

bool hasExtension(VkPhysicalDevice physical, const char* name) {
  std::uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data());
  return std::any_of(extensions.begin(), extensions.end(),
                     [&](const auto& extension) { return std::strcmp(extension.extensionName, name) == 0; });
}

std::vector<std::size_t> matchingDevices(const std::vector<std::string>& names, const std::string& wanted) {
  const bool number =
      !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); });
  std::vector<std::size_t> found;
  if (number) {  // "1" is the second device, where there is one, though the first may have a 1 in its name
    const std::string digits = wanted.substr(std::min(wanted.find_first_not_of('0'), wanted.size() - 1));
    for (std::size_t i = 0; i < names.size(); ++i)
      if (digits == std::to_string(i)) found.push_back(i);
    return found;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    if (lower(names[i]).find(lower(wanted)) != std::string::npos) found.push_back(i);
  return found;
}

Result<Choice> chooseDevice(VkInstance instance, const DeviceOptions& options) {
  std::uint32_t count = 0;
  if (const VkResult result = vkEnumeratePhysicalDevices(instance, &count, nullptr); result != VK_SUCCESS)
    return vkFailed("Vulkan: the devices cannot be listed", result);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  if (count == 0) return failed(kNoDriver);

  std::string wanted = options.name, origin = "device";
  if (const char* variable = std::getenv("TYNDALL_DEVICE"); wanted.empty() && variable)
    wanted = variable, origin = "TYNDALL_DEVICE";
  std::vector<Candidate> candidates;
  std::vector<std::string> names;
  for (const VkPhysicalDevice device : devices) {
    candidates.push_back(examine(device, options));
    names.emplace_back(candidates.back().properties.deviceName);
  }
  const auto matching = matchingDevices(names, wanted);
  const Candidate* best = nullptr;
  for (const std::size_t i : matching) {
    const Candidate& candidate = candidates[i];
    if (!candidate.lacks.empty()) continue;
    if (!best || rank(candidate.properties.deviceType) > rank(best->properties.deviceType)) best = &candidate;
  }
  if (best) return Choice{best->physical, best->family};
  if (matching.empty())
    return badCall(origin + " '" + wanted +
                   "': no such Vulkan device; an index or a part of a name is needed of: " + describe(candidates));
  return failed("Vulkan: no device that the engine can use" + (wanted.empty() ? "" : " is named '" + wanted + "'") +
                ": " + describe(candidates));
}

}  // namespace tyndall::gpu
