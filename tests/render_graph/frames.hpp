// Helpers of the planner's tests: declaring by hand, declaring at random, planning a frame.
#pragma once

#include <random>

#include "simulator.hpp"

namespace tyndall::render::test {

/// Uniform 32 bits.
struct Random {
  std::mt19937 engine;
  explicit Random(std::uint32_t seed) : engine(seed) {}
  std::uint32_t operator()() { return static_cast<std::uint32_t>(engine()); }
};

/// A graph by hand:  Declaration d; auto a = d.image(); d.pass({{a, Use::kColorWrite}});
struct Declaration {
  plan::Input input;
  std::uint32_t image(bool singleSubresource = true);
  std::uint32_t buffer();
  std::uint32_t importImage(VkImageLayout before, VkImageLayout after);
  std::uint32_t importBuffer(bool hostVisible = false);
  std::uint32_t pass(std::vector<plan::ResourceUse> uses, bool keep = false);
};

/// Sizes and alignments for the transients of a declaration (heap 0: buffers, 1 and 2: images).
struct Needs {
  std::uint64_t size = 256, alignment = 16;
  std::uint32_t heap = 1;
};

/// Everything the planner does, with `pending` of the frame before on the same memory (empty: none).
Frame planFrame(const plan::Input& input, const std::vector<Needs>& needs,
                const std::vector<plan::Pending>& pending = {});
Frame planFrame(const plan::Input& input);

struct RandomGraph {
  plan::Input input;
  std::vector<Needs> needs;
};
/// Up to `maxPasses` passes; valid: nothing is read before it is written.
RandomGraph randomGraph(Random& random, std::uint32_t maxPasses);

}  // namespace tyndall::render::test
