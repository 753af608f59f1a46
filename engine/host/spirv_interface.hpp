// The resources that a shader declares, read from its SPIR-V, so that a shader and a table that disagree are an error
// line instead of undefined behaviour in the driver.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <volk.h>

#include "base/result.hpp"

namespace tyndall::host {

struct ShaderBinding {
  std::uint32_t binding = 0;
  VkDescriptorType type = VK_DESCRIPTOR_TYPE_MAX_ENUM;  ///< MAX_ENUM: a kind the host does not offer
};

/// Errors: no SPIR-V; a descriptor set other than 0; an array of descriptors; push constants.
Result<std::vector<ShaderBinding>> shaderBindings(std::span<const std::uint32_t> code);

/// Every binding the shader declares must be among `given`, with the same type; more may be given.
Result<void> checkShaderBindings(std::span<const std::uint32_t> code, const std::vector<ShaderBinding>& given);

}  // namespace tyndall::host
