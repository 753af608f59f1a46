// A machine that replays passes and barriers under the rules of Vulkan's memory model and objects to the first thing
// that those rules do not guarantee. It knows nothing of how the planner decides.
//
// Each access is an event at one stage. A barrier puts an event in its source scope if the event's own stage is in the
// source mask, or if an earlier barrier chains it there; whatever is in the scope is ordered before the barrier's
// target stages. A write is made available by a barrier whose source names its stage and access directly, and visible
// to the target's stage and access pairs of barriers whose scope holds it then or later. A layout transition is a write
// of its own between the two.
#pragma once

#include <string>
#include <vector>

#include "graph_plan.hpp"
#include "vulkan_model.hpp"

namespace tyndall::render::test {

struct Frame {
  plan::Input input;
  std::vector<bool> kept;
  std::vector<plan::Placement> placements;
  plan::Barriers barriers;
};

class Machine {
 public:
  explicit Machine(const Frame& first);
  /// Runs one frame on the same queue as the frames before. "" or what went wrong.
  std::string run(const Frame& frame);

 private:
  struct Range {
    std::uint64_t heap = 0, begin = 0, end = 0;  // imports have a heap of their own
    bool meets(const Range& o) const { return heap == o.heap && begin < o.end && o.begin < end; }
    bool holds(const Range& o) const { return heap == o.heap && begin <= o.begin && o.end <= end; }
  };
  struct Event {
    std::uint32_t resource = 0;
    Range range;
    Stages stage = 0;     // one bit; none for a transition
    Accesses access = 0;  // one bit; none for a transition
    bool write = false, available = false;
    Stages ordered = 0;  // later commands at these stages wait for it
    Visible visible;
    std::string what;
  };

  void place(const Frame& frame);
  std::string barriers(const plan::Input& input, const std::vector<plan::Barrier>& list, const std::string& where);
  std::string transition(const plan::Input& input, const plan::Barrier& barrier, const std::vector<bool>& inScope,
                         std::size_t eventCount, const std::string& where);
  std::string use(const plan::Input& input, std::uint32_t resource, Use use, const std::string& where);
  std::string finish(const plan::Input& input);
  void overwrite(std::uint32_t resource);  ///< other tenants of its memory lose their contents
  void forget(const Range& range);         ///< events that a verified write has superseded

  std::vector<Range> ranges_;  // of each resource; empty for unused transients
  std::vector<VkImageLayout> layouts_;
  std::vector<std::uint64_t> contents_;  // hash; 0: undefined
  std::vector<bool> hostMustSee_;
  std::vector<Event> events_;
};

/// What passes see and leave when every declared pass runs in order on unshared memory with perfect synchronization.
struct Reference {
  std::vector<std::uint64_t> seen;      ///< per pass: hash of all that it reads
  std::vector<std::uint64_t> contents;  ///< per resource at the end
};
/// `contents` are those of the imports when the frame begins; `changed` is a pass that computes something else (~0:
/// none).
Reference reference(const plan::Input& input, std::vector<std::uint64_t> contents, std::uint32_t changed = ~0u);
std::vector<std::uint64_t> initialContents(const plan::Input& input);

/// The same arithmetic for one pass, used by both.
std::uint64_t mix(std::uint64_t a, std::uint64_t b);
std::uint64_t seenBy(const plan::Input& input, std::uint32_t pass, const std::vector<std::uint64_t>& contents);
std::uint64_t written(const plan::Input& input, std::uint32_t pass, const plan::ResourceUse& use, std::uint64_t seen,
                      std::uint64_t before);

}  // namespace tyndall::render::test
