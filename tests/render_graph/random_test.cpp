// Random graphs, replayed by a machine that knows Vulkan's memory model and nothing of the planner.
#include <gtest/gtest.h>

#include <algorithm>

#include "frames.hpp"

namespace tyndall::render::test {
namespace {

constexpr std::uint32_t kCases = 10'000, kPasses = 60;

TEST(RandomGraphs, EveryReadIsVisibleEveryLayoutRightNoLiveMemoryOverwritten) {
  std::uint64_t kept = 0, shared = 0, barriers = 0;
  for (std::uint32_t seed = 0; seed < kCases; ++seed) {
    Random random(seed);
    const RandomGraph graph = randomGraph(random, kPasses);
    ASSERT_EQ(plan::findMistake(graph.input), "") << "seed " << seed;
    const Frame frame = planFrame(graph.input, graph.needs);
    Machine machine(frame);
    for (int repeat = 0; repeat < 3; ++repeat)
      ASSERT_EQ(machine.run(frame), "") << "seed " << seed << ", frame " << repeat;
    kept += std::count(frame.kept.begin(), frame.kept.end(), true);
    for (const plan::Placement& a : frame.placements)
      for (const plan::Placement& b : frame.placements) shared += a.resource < b.resource && a.overlaps(b);
    for (const auto& list : frame.barriers.before) barriers += list.size();
  }
  // The cases are worth something: they keep passes, share memory and need barriers.
  EXPECT_GT(kept, 10u * kCases);
  EXPECT_GT(shared, 10u * kCases);
  EXPECT_GT(barriers, 20u * kCases);
  std::printf("%u graphs: %.1f passes kept, %.1f pairs sharing memory, %.1f barriers each\n", kCases,
              double(kept) / kCases, double(shared) / kCases, double(barriers) / kCases);
}

// A graph of other passes on the same descriptions and places reuses the memory that the last one left in use.
TEST(RandomGraphs, AnotherPlanOnTheSameMemoryWaitsForTheLastOne) {
  std::uint32_t differing = 0;
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    const RandomGraph graph = randomGraph(random, kPasses);
    plan::Input other = graph.input;
    for (plan::PassInput& pass : other.passes)
      for (plan::ResourceUse& use : pass.uses) {
        const bool readsOnly =
            use.use == Use::kSampledCompute || use.use == Use::kSampledGraphics || use.use == Use::kTransferRead;
        if (readsOnly && random() % 2)
          use.use = use.use == Use::kSampledCompute ? Use::kSampledGraphics : Use::kSampledCompute;
      }
    Frame a = planFrame(graph.input, graph.needs);
    const Frame b = planFrame(other, graph.needs, a.barriers.pending);
    ASSERT_EQ(a.placements.size(), b.placements.size());
    const Frame again = planFrame(graph.input, graph.needs, b.barriers.pending);
    Machine machine(a);
    ASSERT_EQ(machine.run(a), "") << "seed " << seed;
    ASSERT_EQ(machine.run(b), "") << "seed " << seed;
    ASSERT_EQ(machine.run(again), "") << "seed " << seed;
    differing += a.barriers.before != b.barriers.before;
  }
  EXPECT_GT(differing, 1000u);
}

// Needed by brute force: change what one pass computes, and see whether anything that must run notices.
TEST(RandomGraphs, ExactlyTheNeededPassesRun) {
  std::uint32_t dropped = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    const plan::Input input = randomGraph(random, kPasses).input;
    const std::vector<bool> kept = plan::cull(input);
    std::vector<bool> mandatory(input.passes.size());
    for (std::uint32_t p = 0; p < input.passes.size(); ++p) {
      mandatory[p] = input.passes[p].keep;
      for (const plan::ResourceUse& use : input.passes[p].uses)
        if (input.resources[use.resource].imported && meaningOf(use.use, false).writes) mandatory[p] = true;
    }
    const std::vector<std::uint64_t> contents = initialContents(input);
    const Reference truth = reference(input, contents);
    for (std::uint32_t p = 0; p < input.passes.size(); ++p) {
      bool needed = mandatory[p];
      const Reference changed = reference(input, contents, p);
      for (std::uint32_t q = 0; q < input.passes.size(); ++q)
        needed = needed || (mandatory[q] && changed.seen[q] != truth.seen[q]);
      ASSERT_EQ(kept[p], needed) << "seed " << seed << ", pass " << p;
      dropped += !needed;
    }
  }
  EXPECT_GT(dropped, 3000u);
}

// The machine must be able to object: a barrier taken away, or one stage or access of it, is a fault it finds. Not
// always: another barrier of the pass may happen to cover it, and some sources are wider than one frame needs.
TEST(RandomGraphs, TheMachineNoticesWhatIsTakenAway) {
  struct Kind {
    const char* name;
    void (*weaken)(std::vector<plan::Barrier>&, std::size_t);
    double atLeast;
  };
  const Kind kinds[] = {
      {"barrier", [](auto& list, std::size_t b) { list.erase(list.begin() + static_cast<std::ptrdiff_t>(b)); }, 0.7},
      {"source stages", [](auto& list, std::size_t b) { list[b].sourceStages = 0; }, 0.7},
      {"target stages", [](auto& list, std::size_t b) { list[b].targetStages = 0; }, 0.7},
      {"source access", [](auto& list, std::size_t b) { list[b].sourceAccess = 0; }, 0.30},  // often 0 already
      {"target access", [](auto& list, std::size_t b) { list[b].targetAccess = 0; }, 0.60},
  };
  for (const Kind& kind : kinds) {
    std::uint32_t tried = 0, noticed = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
      Random random(seed);
      const RandomGraph graph = randomGraph(random, kPasses);
      Frame frame = planFrame(graph.input, graph.needs);
      std::vector<std::size_t> passes;
      for (std::size_t p = 0; p < frame.barriers.before.size(); ++p)
        if (!frame.barriers.before[p].empty()) passes.push_back(p);
      if (passes.empty()) continue;
      auto& list = frame.barriers.before[passes[random() % passes.size()]];
      kind.weaken(list, random() % list.size());
      Machine machine(frame);
      ++tried;
      bool objected = false;
      for (int repeat = 0; repeat < 3 && !objected; ++repeat) objected = !machine.run(frame).empty();
      noticed += objected;
    }
    std::printf("%s taken away: %u of %u noticed\n", kind.name, noticed, tried);
    EXPECT_GT(noticed, kind.atLeast * tried) << kind.name;
  }
}

}  // namespace
}  // namespace tyndall::render::test
