// Barriers from uses. Each resource is a timeline of uses by kept passes, cut into spans: a write is a span, and so is
// a run of reads in one layout. Exactly one barrier stands at the start of each span; its target is the whole span, so
// that reads after reads need none. Its source is the span before:
//   after a write   its stages and its writes, to be made available;
//   after reads     their stages alone: their own barrier has made the write before them available, and the chain of
//                   execution dependencies through them orders the rest.
// The first span of an import waits for every earlier command. The first span of a transient waits for the last spans
// of everything that lies on the same memory, itself included. The last span, not an earlier one: all spans of a
// resource are chained by their barriers. Frames in flight overlap on the queue and use the same memory; a barrier's
// source reaches over submissions on one queue, so the same wait covers the last frame, and the plan is the same for
// every frame.
#include <algorithm>

#include "graph_plan.hpp"

namespace tyndall::render::plan {
namespace {

struct Span {
  std::uint32_t firstPass = 0;
  VkPipelineStageFlags2 stages = 0;
  VkAccessFlags2 access = 0, writes = 0;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;  // buffers: always UNDEFINED
};

using Timeline = std::vector<Span>;

std::vector<Timeline> timelines(const Input& input, const std::vector<bool>& kept) {
  std::vector<Timeline> result(input.resources.size());
  for (std::uint32_t p = 0; p < input.passes.size(); ++p) {
    if (!kept[p]) continue;
    for (const ResourceUse& use : input.passes[p].uses) {
      const UseInfo info = useInfo(use.use);
      const VkImageLayout layout = input.resources[use.resource].isBuffer ? VK_IMAGE_LAYOUT_UNDEFINED : info.layout;
      Timeline& timeline = result[use.resource];
      const bool continuesRun =
          !timeline.empty() && timeline.back().writes == 0 && info.writeAccess == 0 && timeline.back().layout == layout;
      if (continuesRun) {
        timeline.back().stages |= info.stages;
        timeline.back().access |= info.access;
      } else {
        timeline.push_back({p, info.stages, info.access, info.writeAccess, layout});
      }
    }
  }
  return result;
}

Pending pendingOf(const Span& span) { return {span.stages, span.writes}; }

void join(Pending& pending, const Pending& other) {
  pending.stages |= other.stages;
  pending.writes |= other.writes;
}

void add(std::vector<Barrier>& list, const Barrier& barrier) {
  if (std::find(list.begin(), list.end(), barrier) == list.end()) list.push_back(barrier);
}

Barrier between(std::uint32_t resource, bool isBuffer, const Pending& from, VkImageLayout oldLayout, const Span& to) {
  Barrier barrier{Barrier::kMemory, from.stages, from.writes, to.stages, to.access};
  if (!isBuffer) {
    barrier.resource = resource;
    barrier.oldLayout = oldLayout;
    barrier.newLayout = to.layout;
  }
  return barrier;
}

void beginTransients(const std::vector<Timeline>& all, const Input& input, const std::vector<Placement>& placements,
                     Barriers& barriers) {
  for (const Placement& placement : placements) {
    const Timeline& timeline = all[placement.resource];
    if (timeline.empty()) continue;
    Pending from;
    bool shared = false;
    for (const Placement& other : placements) {
      if (!placement.overlaps(other) || all[other.resource].empty()) continue;
      join(from, pendingOf(all[other.resource].back()));
      join(from, other.pending);
      shared = shared || other.resource != placement.resource;
    }
    const bool isBuffer = input.resources[placement.resource].isBuffer;
    const Span& first = timeline.front();
    std::vector<Barrier>& list = barriers.before[first.firstPass];
    // An image barrier makes available only what was written through that image; a tenant before it wrote through
    // another.
    if (shared || isBuffer) add(list, between(Barrier::kMemory, true, from, VK_IMAGE_LAYOUT_UNDEFINED, first));
    if (!isBuffer) add(list, between(placement.resource, false, from, VK_IMAGE_LAYOUT_UNDEFINED, first));
  }
}

// The caller goes on with an import after the frame: by commands of any kind, or on the host.
void endImport(std::uint32_t index, const ResourceInput& resource, const Timeline& timeline, const Pending& pending,
               Barriers& barriers) {
  const bool written = std::any_of(timeline.begin(), timeline.end(), [](const Span& span) { return span.writes != 0; });
  const VkImageLayout layout = timeline.empty() ? resource.layoutBefore : timeline.back().layout;
  const VkImageLayout wanted = resource.layoutAfter == VK_IMAGE_LAYOUT_UNDEFINED ? layout : resource.layoutAfter;
  if (!written && (resource.isBuffer || layout == wanted)) return;
  Span after{.stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
             .access = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
             .layout = wanted};
  if (resource.hostVisible) {
    after.stages |= VK_PIPELINE_STAGE_2_HOST_BIT;
    after.access |= VK_ACCESS_2_HOST_READ_BIT;
  }
  add(barriers.after, between(index, resource.isBuffer, pending, layout, after));
}

}  // namespace

Barriers deriveBarriers(const Input& input, const std::vector<bool>& kept, const std::vector<Placement>& placements) {
  const std::vector<Timeline> all = timelines(input, kept);
  Barriers barriers;
  barriers.before.resize(input.passes.size());
  barriers.pending.resize(input.resources.size());
  const Pending anything{VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT};

  beginTransients(all, input, placements, barriers);
  for (std::uint32_t r = 0; r < input.resources.size(); ++r) {
    const ResourceInput& resource = input.resources[r];
    const Timeline& timeline = all[r];
    if (resource.imported && !timeline.empty())
      add(barriers.before[timeline.front().firstPass],
          between(r, resource.isBuffer, anything, resource.layoutBefore, timeline.front()));
    for (std::size_t s = 1; s < timeline.size(); ++s)
      add(barriers.before[timeline[s].firstPass],
          between(r, resource.isBuffer, pendingOf(timeline[s - 1]), timeline[s - 1].layout, timeline[s]));
    barriers.pending[r] = timeline.empty() ? anything : pendingOf(timeline.back());
    if (resource.imported) endImport(r, resource, timeline, barriers.pending[r], barriers);
  }
  return barriers;
}

}  // namespace tyndall::render::plan
