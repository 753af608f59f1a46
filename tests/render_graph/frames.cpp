#include "frames.hpp"

#include <algorithm>

namespace tyndall::render::test {

std::uint32_t Declaration::image(bool singleSubresource) {
  input.resources.push_back({.name = "image", .singleSubresource = singleSubresource});
  return static_cast<std::uint32_t>(input.resources.size() - 1);
}

std::uint32_t Declaration::buffer() {
  input.resources.push_back({.name = "buffer", .isBuffer = true});
  return static_cast<std::uint32_t>(input.resources.size() - 1);
}

std::uint32_t Declaration::importImage(VkImageLayout before, VkImageLayout after) {
  input.resources.push_back({.name = "imported image",
                             .imported = true,
                             .singleSubresource = true,
                             .layoutBefore = before,
                             .layoutAfter = after});
  return static_cast<std::uint32_t>(input.resources.size() - 1);
}

std::uint32_t Declaration::importBuffer(bool hostVisible) {
  input.resources.push_back(
      {.name = "imported buffer", .isBuffer = true, .imported = true, .hostVisible = hostVisible});
  return static_cast<std::uint32_t>(input.resources.size() - 1);
}

std::uint32_t Declaration::pass(std::vector<plan::ResourceUse> uses, bool keep) {
  input.passes.push_back(
      {.name = "pass " + std::to_string(input.passes.size()), .keep = keep, .uses = std::move(uses)});
  return static_cast<std::uint32_t>(input.passes.size() - 1);
}

Frame planFrame(const plan::Input& input, const std::vector<Needs>& needs, const std::vector<plan::Pending>& pending) {
  Frame frame{.input = input, .kept = plan::cull(input)};
  const std::vector<plan::Life> lives = plan::lives(input, frame.kept);
  std::vector<plan::Block> blocks;
  for (std::uint32_t r = 0; r < input.resources.size(); ++r) {
    if (input.resources[r].imported || !lives[r].used()) continue;
    blocks.push_back({needs[r].size, needs[r].alignment, lives[r], needs[r].heap});
    frame.placements.push_back({r, needs[r].heap, 0, needs[r].size, pending.empty() ? plan::Pending{} : pending[r]});
  }
  const plan::Packing packing = plan::pack(blocks, 3);
  for (std::size_t i = 0; i < blocks.size(); ++i) frame.placements[i].offset = packing.offsets[i];
  frame.barriers = plan::deriveBarriers(input, frame.kept, frame.placements);
  return frame;
}

Frame planFrame(const plan::Input& input) {
  std::vector<Needs> needs(input.resources.size());
  for (std::size_t r = 0; r < needs.size(); ++r) needs[r].heap = input.resources[r].isBuffer ? 0 : 1;
  return planFrame(input, needs);
}

namespace {

constexpr Use kImageReads[] = {Use::kSampledCompute, Use::kSampledGraphics, Use::kStorageReadCompute, Use::kDepthRead,
                               Use::kTransferRead};
constexpr Use kImageWrites[] = {Use::kStorageWriteCompute, Use::kColorWrite, Use::kDepthWrite, Use::kTransferWrite};
constexpr Use kImageBoth[] = {Use::kStorageReadWriteCompute, Use::kSampledStorageCompute, Use::kColorReadWrite,
                              Use::kDepthReadWrite};
constexpr Use kBufferReads[] = {Use::kSampledCompute, Use::kSampledGraphics, Use::kStorageReadCompute,
                                Use::kTransferRead,   Use::kUniform,         Use::kIndirect};
constexpr Use kBufferWrites[] = {Use::kStorageWriteCompute, Use::kTransferWrite};
constexpr Use kBufferBoth[] = {Use::kStorageReadWriteCompute};

template <class Array>
Use pick(Random& random, const Array& uses) {
  return uses[random() % std::size(uses)];
}

Use randomUse(Random& random, bool isBuffer, bool hasContents) {
  const std::uint32_t kind = random() % 10;
  if (!hasContents || kind >= 7) return isBuffer ? pick(random, kBufferWrites) : pick(random, kImageWrites);
  if (kind >= 5) return isBuffer ? pick(random, kBufferBoth) : pick(random, kImageBoth);
  return isBuffer ? pick(random, kBufferReads) : pick(random, kImageReads);
}

std::uint32_t randomResource(Random& random, Declaration& d) {
  const std::uint32_t kind = random() % 16;
  if (kind == 0) return d.importBuffer(random() % 2 == 0);
  if (kind == 1)
    return d.importImage(VK_IMAGE_LAYOUT_UNDEFINED,
                         random() % 2 ? VK_IMAGE_LAYOUT_PRESENT_SRC_KHR : VK_IMAGE_LAYOUT_UNDEFINED);
  if (kind == 2) {
    const VkImageLayout layout = random() % 2 ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    return d.importImage(layout, layout);
  }
  return kind < 7 ? d.buffer() : d.image(random() % 3 != 0);
}

}  // namespace

RandomGraph randomGraph(Random& random, std::uint32_t maxPasses) {
  Declaration d;
  const std::uint32_t passes = 1 + random() % maxPasses, count = 1 + random() % (passes + 2);
  for (std::uint32_t r = 0; r < count; ++r) randomResource(random, d);
  std::vector<bool> hasContents(count);
  for (std::uint32_t r = 0; r < count; ++r)
    hasContents[r] = d.input.resources[r].imported &&
                     (d.input.resources[r].isBuffer || d.input.resources[r].layoutBefore != VK_IMAGE_LAYOUT_UNDEFINED);
  for (std::uint32_t p = 0; p < passes; ++p) {
    std::vector<plan::ResourceUse> uses;
    const std::uint32_t useCount = random() % 5;
    for (std::uint32_t u = 0; u < useCount; ++u) {
      // Mostly neighbours of p's place in the list, so that lives are short and memory is shared.
      const std::uint32_t near = (p * count / passes + random() % 5) % count;
      const std::uint32_t r = random() % 4 ? near : random() % count;
      const bool seen =
          std::any_of(uses.begin(), uses.end(), [&](const plan::ResourceUse& x) { return x.resource == r; });
      if (!seen) uses.push_back({r, randomUse(random, d.input.resources[r].isBuffer, hasContents[r])});
    }
    for (const plan::ResourceUse& use : uses)
      if (writes(use.use)) hasContents[use.resource] = true;
    d.pass(std::move(uses), random() % 3 == 0);
  }
  RandomGraph graph{d.input, std::vector<Needs>(count)};
  for (std::uint32_t r = 0; r < count; ++r)
    graph.needs[r] = {1 + random() % 1000, 1ull << (random() % 9),
                      d.input.resources[r].isBuffer ? 0u : 1u + (random() % 4 == 0)};
  return graph;
}

}  // namespace tyndall::render::test
