// Compiling: from the declaration to physical resources and barriers.
#include <algorithm>
#include <utility>

#include "base/assert.hpp"
#include "graph_state.hpp"

namespace tyndall::render {

void Graph::State::describe() {
  input = {};
  for (const GraphResource& resource : resources) {
    const gpu::ImageDesc& desc = resource.imageDesc;
    input.resources.push_back(
        {.name = resource.isBuffer ? resource.bufferDesc.name : desc.name,
         .isBuffer = resource.isBuffer,
         .imported = resource.imported(),
         .hostVisible = resource.isBuffer && resource.bufferDesc.hostVisible,
         .singleSubresource = !resource.isBuffer && desc.mips == 1 && desc.layers == 1 && desc.depth == 1,
         .layoutBefore = resource.before,
         .layoutAfter = resource.after});
  }
  for (const GraphPass& pass : passes) {
    TY_ASSERT(pass.record, "pass '" + pass.name + "' has no run()");
    input.passes.push_back({pass.name, pass.keep, pass.uses});
  }
  const std::string mistake = plan::findMistake(input);
  TY_ASSERT(mistake.empty(), mistake);
}

namespace {

// Usage from the kept passes. Every transient can also be read back and sampled (debug views, tests).
void deriveUsage(const plan::Input& input, const std::vector<bool>& kept, std::vector<PhysicalResource>& byResource) {
  for (PhysicalResource& resource : byResource) {
    if (resource.isBuffer) {
      resource.bufferDesc.usage |= VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    } else {
      resource.imageDesc.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
      if (aspectOf(resource.imageDesc.format) != VK_IMAGE_ASPECT_COLOR_BIT)
        resource.imageDesc.usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    }
  }
  for (std::size_t p = 0; p < input.passes.size(); ++p) {
    if (!kept[p]) continue;
    for (const plan::ResourceUse& use : input.passes[p].uses) {
      byResource[use.resource].imageDesc.usage |= useInfo(use.use).imageUsage;
      byResource[use.resource].bufferDesc.usage |= useInfo(use.use).bufferUsage;
    }
  }
}

std::uint32_t findHeap(std::vector<Heap>& heaps, bool isBuffer, const VkMemoryRequirements& needed) {
  const auto found = std::find_if(heaps.begin(), heaps.end(), [&](const Heap& heap) {
    return heap.isBuffer == isBuffer && heap.memoryTypes == needed.memoryTypeBits;
  });
  const auto index = static_cast<std::uint32_t>(found - heaps.begin());
  if (found == heaps.end()) heaps.push_back({.isBuffer = isBuffer, .memoryTypes = needed.memoryTypeBits});
  heaps[index].alignment = std::max(heaps[index].alignment, needed.alignment);
  return index;
}

}  // namespace

Result<void> Graph::State::allocate(std::vector<plan::Placement>& placements) {
  const std::vector<plan::Life> lives = plan::lives(input, kept);
  std::vector<PhysicalResource> byResource(resources.size());
  for (std::size_t r = 0; r < resources.size(); ++r) {
    byResource[r].isBuffer = resources[r].isBuffer;
    byResource[r].imageDesc = resources[r].imageDesc;
    byResource[r].bufferDesc = resources[r].bufferDesc;
  }
  deriveUsage(input, kept, byResource);

  std::vector<Heap> heaps;
  std::vector<PhysicalResource> physical;
  std::vector<VkMemoryRequirements> requirements;
  std::vector<plan::Block> blocks;
  for (std::size_t r = 0; r < resources.size(); ++r) {
    resources[r].physical = ~0u;
    resources[r].bytes = 0;
    if (resources[r].imported() || !lives[r].used()) continue;
    const auto asked = memory.requirementsOf(byResource[r]);
    if (!asked) return asked.error();
    const VkMemoryRequirements& needed = *asked;
    byResource[r].heap = findHeap(heaps, resources[r].isBuffer, needed);
    resources[r].physical = static_cast<std::uint32_t>(physical.size());
    resources[r].bytes = needed.size;
    blocks.push_back({needed.size, needed.alignment, lives[r], byResource[r].heap});
    requirements.push_back(needed);
    physical.push_back(std::move(byResource[r]));
  }

  const plan::Packing packing = plan::pack(blocks, static_cast<std::uint32_t>(heaps.size()));
  for (std::size_t h = 0; h < heaps.size(); ++h) heaps[h].size = packing.heapSizes[h];
  for (std::size_t i = 0; i < physical.size(); ++i) physical[i].offset = packing.offsets[i];
  if (auto done = memory.realize(std::move(heaps), std::move(physical), std::move(requirements)); !done) return done;

  for (std::uint32_t r = 0; r < resources.size(); ++r) {
    if (resources[r].physical == ~0u) continue;
    const PhysicalResource& place = memory.resources[resources[r].physical];
    placements.push_back({r, place.heap, place.offset, resources[r].bytes, place.pending});
  }
  return {};
}

void Graph::State::countStatistics() {
  statistics = {.passesDeclared = static_cast<std::uint32_t>(passes.size()),
                .passesRun = static_cast<std::uint32_t>(std::count(kept.begin(), kept.end(), true)),
                .barriers = static_cast<std::uint32_t>(barriers.after.size())};
  for (const auto& list : barriers.before) statistics.barriers += static_cast<std::uint32_t>(list.size());
  statistics.waitedForMemory = std::exchange(memory.waited, false);
  for (const Heap& heap : memory.heaps) statistics.transientBytes += heap.size;
  for (const GraphResource& resource : resources) statistics.transientBytesUnshared += resource.bytes;
}

Result<void> Graph::compile() {
  State& s = *state_;
  TY_ASSERT(!s.compiled, "compile() was called twice");
  s.describe();
  s.kept = plan::cull(s.input);
  std::vector<plan::Placement> placements;
  if (auto done = s.allocate(placements); !done) return done;
  s.barriers = plan::deriveBarriers(s.input, s.kept, placements);
  s.countStatistics();
  s.compileId = ++s.memory.compiles;
  s.compiled = true;
  return {};
}

GraphStatistics Graph::statistics() const { return state_->statistics; }

std::vector<TransientUse> Graph::transients() const {
  const State& s = *state_;
  TY_ASSERT(s.compiled && s.compileId == s.memory.compiles, "transients() before compile(), or after another graph's");
  const std::vector<plan::Life> lives = plan::lives(s.input, s.kept);
  std::vector<TransientUse> uses;
  for (std::size_t r = 0; r < s.resources.size(); ++r) {
    const GraphResource& resource = s.resources[r];
    if (resource.imported() || resource.physical == ~0u) continue;
    const PhysicalResource& place = s.memory.resources[resource.physical];
    TransientUse& use = uses.emplace_back();
    use.name = s.input.resources[r].name;
    use.owner = resource.owner;
    if (!resource.isBuffer) use.image = place.imageDesc;
    use.heap = place.heap;
    use.offset = place.offset;
    use.bytes = resource.bytes;
    use.firstPass = s.passes[lives[r].first].name;
    use.lastPass = s.passes[lives[r].last].name;
  }
  return uses;
}

VkDeviceSize Graph::ownerBytes(std::string_view owner) const {
  VkDeviceSize bytes = 0;
  for (const GraphResource& resource : state_->resources)
    if (resource.owner == owner) bytes += resource.bytes;
  return bytes;
}

std::vector<PassTime> Graph::passes() const {
  std::vector<PassTime> result;
  for (std::size_t p = 0; p < state_->kept.size(); ++p)
    if (state_->kept[p] && !state_->passes[p].idle)
      result.push_back({state_->passes[p].name, state_->passes[p].owner, 0});
  return result;
}

}  // namespace tyndall::render
