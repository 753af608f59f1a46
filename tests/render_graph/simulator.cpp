#include "simulator.hpp"

#include <algorithm>

namespace tyndall::render::test {

Machine::Machine(const Frame& first)
    : layouts_(first.input.resources.size(), VK_IMAGE_LAYOUT_UNDEFINED),
      contents_(initialContents(first.input)),
      hostMustSee_(first.input.resources.size()) {
  for (std::size_t r = 0; r < layouts_.size(); ++r)
    if (first.input.resources[r].imported) layouts_[r] = first.input.resources[r].layoutBefore;
}

void Machine::place(const Frame& frame) {
  ranges_.assign(frame.input.resources.size(), {});
  for (std::uint32_t r = 0; r < ranges_.size(); ++r)
    if (frame.input.resources[r].imported) ranges_[r] = {1000ull + r, 0, 1};
  for (const plan::Placement& p : frame.placements) ranges_[p.resource] = {p.heap, p.offset, p.offset + p.size};
}

std::string Machine::run(const Frame& frame) {
  place(frame);
  const plan::Input& input = frame.input;
  const Reference expected = reference(input, contents_);
  for (std::uint32_t r = 0; r < contents_.size(); ++r)
    if (!input.resources[r].imported) contents_[r] = 0;  // nobody may count on the last frame's transients
  for (std::uint32_t p = 0; p < input.passes.size(); ++p) {
    const std::string where = "pass " + std::to_string(p);
    if (!frame.kept[p]) {
      if (!frame.barriers.before[p].empty()) return where + " is dropped and has barriers";
      continue;
    }
    if (std::string wrong = barriers(input, frame.barriers.before[p], where); !wrong.empty()) return wrong;
    for (const plan::ResourceUse& u : input.passes[p].uses)
      if (std::string wrong = use(input, u.resource, u.use, where); !wrong.empty()) return wrong;
    const std::uint64_t seen = seenBy(input, p, contents_);
    if (seen != expected.seen[p]) return where + " reads other contents than the declared passes left";
    for (const plan::ResourceUse& u : input.passes[p].uses) {
      if (!meaningOf(u.use, input.resources[u.resource].isBuffer).writes) continue;
      contents_[u.resource] = written(input, p, u, seen, contents_[u.resource]);
      overwrite(u.resource);
      hostMustSee_[u.resource] = true;
    }
  }
  if (std::string wrong = barriers(input, frame.barriers.after, "after the frame"); !wrong.empty()) return wrong;
  for (std::uint32_t r = 0; r < contents_.size(); ++r) {
    const plan::ResourceInput& resource = input.resources[r];
    // An import nobody touches keeps its contents, even if the first use would have discarded them.
    if (resource.imported && ranges_[r].end && contents_[r] != expected.contents[r] && expected.contents[r] != 0)
      return "resource " + std::to_string(r) + " ends with other contents than the declared passes left";
  }
  return finish(input);
}

std::string Machine::barriers(const plan::Input& input, const std::vector<plan::Barrier>& list,
                              const std::string& where) {
  const std::size_t count = events_.size();
  std::vector<std::vector<bool>> inScope(list.size(), std::vector<bool>(count));
  const std::vector<Event> before = events_;  // entries of one command do not chain with each other
  for (std::size_t b = 0; b < list.size(); ++b) {
    const plan::Barrier& barrier = list[b];
    const Stages source = stagesOf(barrier.sourceStages), target = stagesOf(barrier.targetStages);
    for (std::size_t e = 0; e < count; ++e) {
      Event& event = events_[e];
      const bool direct = before[e].stage & source;
      inScope[b][e] = direct || (before[e].ordered & source);
      if (!inScope[b][e]) continue;
      event.ordered |= target;
      if (!event.write || (barrier.resource != plan::Barrier::kMemory && barrier.resource != event.resource)) continue;
      const bool madeAvailable = direct && (event.access & accessesOf(barrier.sourceAccess));
      event.available = event.available || madeAvailable;
      if (before[e].available || madeAvailable) event.visible |= product(target, accessesOf(barrier.targetAccess));
    }
  }
  for (std::size_t b = 0; b < list.size(); ++b) {
    if (list[b].resource == plan::Barrier::kMemory) continue;
    if (std::string wrong = transition(input, list[b], inScope[b], count, where); !wrong.empty()) return wrong;
  }
  events_.erase(std::remove_if(events_.begin(), events_.end(), [](const Event& e) { return e.range.end == 0; }),
                events_.end());
  return {};
}

std::string Machine::transition(const plan::Input& input, const plan::Barrier& barrier,
                                const std::vector<bool>& inScope, std::size_t eventCount, const std::string& where) {
  const std::uint32_t r = barrier.resource;
  const std::string what = where + ", image " + std::to_string(r) + ": ";
  if (input.resources[r].isBuffer) return what + "an image barrier for a buffer";
  if (!ranges_[r].end) return what + "a barrier for an image without memory";
  if (barrier.newLayout == VK_IMAGE_LAYOUT_UNDEFINED) return what + "a transition to UNDEFINED";
  if (barrier.oldLayout != VK_IMAGE_LAYOUT_UNDEFINED && barrier.oldLayout != layouts_[r])
    return what + "the barrier believes in layout " + std::to_string(barrier.oldLayout) + ", it is " +
           std::to_string(layouts_[r]);
  if (barrier.oldLayout == barrier.newLayout) return {};
  for (std::size_t e = 0; e < events_.size(); ++e) {
    const Event& event = events_[e];
    if (!event.range.end || !event.range.meets(ranges_[r])) continue;
    if (e >= eventCount || !inScope[e]) return what + "the transition does not wait for " + event.what;
    if (event.write && !event.available) return what + "the transition is not after the flush of " + event.what;
  }
  if (barrier.oldLayout == VK_IMAGE_LAYOUT_UNDEFINED) contents_[r] = 0;
  overwrite(r);
  for (Event& event : events_)
    if (ranges_[r].holds(event.range)) event.range = {};  // erased by the caller: indices must stay for now
  layouts_[r] = barrier.newLayout;
  const Stages target = stagesOf(barrier.targetStages);
  events_.push_back({r, ranges_[r], 0, 0, true, true, target, product(target, accessesOf(barrier.targetAccess)),
                     "the transition at " + where});
  return {};
}

std::string Machine::use(const plan::Input& input, std::uint32_t r, Use use, const std::string& where) {
  const plan::ResourceInput& resource = input.resources[r];
  const Meaning m = meaningOf(use, resource.isBuffer);
  const std::string what = where + ", resource " + std::to_string(r) + ": ";
  if (!ranges_[r].end) return what + "used without memory";
  if (!resource.isBuffer && layouts_[r] != m.layout)
    return what + "is in layout " + std::to_string(layouts_[r]) + ", used in " + std::to_string(m.layout);
  if (m.needsContents && contents_[r] == 0) return what + "reads undefined contents";
  for (const Event& event : events_) {
    if (!event.range.meets(ranges_[r]) || (!event.write && !m.writes)) continue;
    if (m.stages & ~event.ordered) return what + "is not ordered after " + event.what;
    if (!event.write) continue;
    if (!event.available) return what + "follows a write that is not available: " + event.what;
    const Visible needed = product(m.stages, m.reads | m.writes);
    if (event.resource == r && (needed & ~event.visible).any()) return what + "does not see " + event.what;
  }
  if (m.writes) forget(ranges_[r]);
  for (std::uint32_t s = 0; s < sStageCount; ++s) {
    if (!(m.stages & bit(s))) continue;
    events_.push_back({r,
                       ranges_[r],
                       bit(s),
                       m.writes ? m.writes : m.reads,
                       m.writes != 0,
                       false,
                       0,
                       {},
                       (m.writes ? "the write at " : "the read at ") + where});
  }
  return {};
}

std::string Machine::finish(const plan::Input& input) {
  for (std::uint32_t r = 0; r < ranges_.size(); ++r) {
    const plan::ResourceInput& resource = input.resources[r];
    if (!resource.imported) continue;
    const std::string what = "after the frame, import " + std::to_string(r) + ": ";
    if (!resource.isBuffer && resource.layoutAfter != VK_IMAGE_LAYOUT_UNDEFINED && layouts_[r] != resource.layoutAfter)
      return what + "is in layout " + std::to_string(layouts_[r]) + ", promised " +
             std::to_string(resource.layoutAfter);
    if (!hostMustSee_[r]) continue;
    Visible needed = product(kAllCommands, kReads & ~bit(aHostRead));
    if (resource.hostVisible) needed |= product(bit(sHost), bit(aHostRead));
    for (const Event& event : events_)
      if (event.resource == r && event.write && (needed & ~event.visible).any())
        return what + "later commands or the host do not see " + event.what;
    hostMustSee_[r] = false;
  }
  return {};
}

void Machine::overwrite(std::uint32_t r) {
  for (std::uint32_t other = 0; other < ranges_.size(); ++other)
    if (other != r && ranges_[other].end && ranges_[other].meets(ranges_[r])) contents_[other] = 0;
}

void Machine::forget(const Range& range) {
  events_.erase(std::remove_if(events_.begin(), events_.end(), [&](const Event& e) { return range.holds(e.range); }),
                events_.end());
}

}  // namespace tyndall::render::test
