// What the simulator knows of Vulkan, written from the specification and not from the planner's table: the stages and
// accesses of a use as small bit sets, and the meaning of barrier masks.
#pragma once

#include <bitset>
#include <cstdint>

#include "render/graph.hpp"

namespace tyndall::render::test {

enum : std::uint32_t { sIndirect, sVertex, sFragment, sEarly, sLate, sColor, sCompute, sTransfer, sHost, sStageCount };
enum : std::uint32_t {
  aIndirect,
  aUniform,
  aSampled,
  aStorageRead,
  aStorageWrite,
  aColorRead,
  aColorWrite,
  aDepthRead,
  aDepthWrite,
  aTransferRead,
  aTransferWrite,
  aHostRead,
  aAccessCount
};
using Stages = std::uint32_t;    // bit per s...
using Accesses = std::uint32_t;  // bit per a...
constexpr std::uint32_t bit(std::uint32_t index) { return 1u << index; }
constexpr Stages kAllCommands = bit(sStageCount) - 1 - bit(sHost);
constexpr Accesses kWrites = bit(aStorageWrite) | bit(aColorWrite) | bit(aDepthWrite) | bit(aTransferWrite);
constexpr Accesses kReads = bit(aAccessCount) - 1 - kWrites;

/// Every (stage, access) pair to which a write is visible.
using Visible = std::bitset<std::uint32_t{sStageCount} * std::uint32_t{aAccessCount}>;
inline Visible product(Stages stages, Accesses accesses) {
  Visible result;
  for (std::uint32_t s = 0; s < sStageCount; ++s)
    for (std::uint32_t a = 0; a < aAccessCount; ++a)
      if (stages & bit(s) && accesses & bit(a)) result.set(s * std::uint32_t{aAccessCount} + a);
  return result;
}

Stages stagesOf(VkPipelineStageFlags2 mask);
Accesses accessesOf(VkAccessFlags2 mask);

struct Meaning {
  Stages stages = 0;
  Accesses reads = 0, writes = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  bool needsContents = false;  ///< the result depends on what was there
  bool replacesAll = false;    ///< nothing of what was there remains (of a resource with one subresource)
};
Meaning meaningOf(Use use, bool isBuffer);

}  // namespace tyndall::render::test
