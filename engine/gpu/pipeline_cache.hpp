// The pipeline cache's file: one per device and driver, with a checksum of its own, since drivers differ in how well
// they survive a damaged cache.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "state.hpp"

namespace tyndall::gpu {

std::vector<std::byte> packCache(std::span<const std::byte> data);
/// The data that was packed; none if the file is damaged or is something else.
std::optional<std::vector<std::byte>> unpackCache(std::span<const std::byte> file);

/// Reads the file, or starts an empty cache.
void openPipelineCache(Device::State& state, const VkPhysicalDeviceProperties& properties);
/// Writes the file if there is something new to keep, and destroys the cache.
void savePipelineCache(Device::State& state);

}  // namespace tyndall::gpu
