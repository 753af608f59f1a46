#include <algorithm>
#include <string>

#include "base/log.hpp"
#include "state.hpp"

namespace tyndall::gpu {
namespace {

// One mistake in a frame repeats every frame; the first lines tell the story.
constexpr std::uint32_t kPrinted = 25;

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  const std::uint32_t count = ++static_cast<ValidationLog*>(user)->messages;
  if (count > kPrinted) return VK_FALSE;
  std::string line = std::string("validation: ") + (data->pMessage ? data->pMessage : "(no text)");
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT)
    log::error(line);
  else
    log::warning(line);
  if (count == kPrinted) log::warning("validation: further messages are counted but not printed");
  return VK_FALSE;
}

}  // namespace

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(ValidationLog& log) {
  VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  info.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  // Not GENERAL: there the loader complains about other drivers of the machine, which is no fault of ours.
  info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  info.pfnUserCallback = onMessage;
  info.pUserData = &log;
  return info;
}

}  // namespace tyndall::gpu
