// Where a device's memory goes, resource by resource.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/session.hpp"

namespace tyndall::app {

struct ResourceMemory {
  std::string name;
  std::string owner;  ///< "engine" or a plugin's id; "" for what is kept
  std::string what;   ///< "1024x1024 RGBA16 float, 3 layers, 4 mips", "buffer", "shared in turn"
  std::uint64_t bytes = 0;
  std::string firstPass, lastPass;  ///< of the frame, that use it; "" for what is kept
};

/// What is kept from frame to frame, the largest first. Together they are all that the device has allocated; the memory
/// that a frame's passing images and buffers share is among them.
std::vector<ResourceMemory> keptMemory(const gpu::Device& device);
/// The last submitted frame's passing images and buffers, the largest first. Together they are more than the memory
/// that they share.
std::vector<ResourceMemory> passingMemory(const Session& session);

}  // namespace tyndall::app
