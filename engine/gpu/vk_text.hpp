// Vulkan's answers and names in words, for error messages.
#pragma once

#include <string>

#include <volk.h>

#include "base/result.hpp"

namespace tyndall::gpu {

std::string text(VkResult result);
/// "<what>: <result>"
Error vkFailed(const std::string& what, VkResult result);

}  // namespace tyndall::gpu
