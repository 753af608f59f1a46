// Culling, packing and refused declarations by hand.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frames.hpp"

namespace tyndall::render::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Culling, KeepsTheChainBehindAnImportAndNothingElse) {
  Declaration d;
  const auto a = d.image(), b = d.image(), unread = d.image(),
             screen = d.importImage(VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  d.pass({{a, Use::kStorageWriteCompute}});
  d.pass({{a, Use::kSampledCompute}, {unread, Use::kStorageWriteCompute}});
  d.pass({{a, Use::kSampledCompute}, {b, Use::kStorageWriteCompute}});
  d.pass({{b, Use::kSampledCompute}, {screen, Use::kStorageWriteCompute}});
  d.pass({{screen, Use::kSampledGraphics}});
  EXPECT_THAT(plan::cull(d.input), ElementsAre(true, false, true, true, false));
}

TEST(Culling, ReadWriteReadsWhatItWritesOver) {
  Declaration d;
  const auto a = d.image();
  d.pass({{a, Use::kColorWrite}});
  d.pass({{a, Use::kColorReadWrite}});
  d.pass({{a, Use::kSampledGraphics}}, true);
  d.pass({{a, Use::kColorReadWrite}});  // after the last read: nobody sees it
  EXPECT_THAT(plan::cull(d.input), ElementsAre(true, true, true, false));
}

TEST(Culling, AWholeOverwriteEndsAVersionAPartialOneDoesNot) {
  for (const bool single : {true, false}) {
    Declaration d;
    const auto a = d.image(single);
    d.pass({{a, Use::kDepthWrite}});
    d.pass({{a, Use::kDepthWrite}});
    d.pass({{a, Use::kSampledGraphics}}, true);
    EXPECT_THAT(plan::cull(d.input), ElementsAre(!single, true, true));
  }
}

TEST(Culling, ADroppedPassCostsNothing) {
  Declaration d;
  const auto a = d.image(), b = d.image();
  d.pass({{a, Use::kStorageWriteCompute}});
  d.pass({{a, Use::kSampledCompute}, {b, Use::kStorageWriteCompute}});
  const Frame frame = planFrame(d.input);
  EXPECT_THAT(frame.kept, ElementsAre(false, false));
  EXPECT_TRUE(frame.placements.empty());
  EXPECT_TRUE(frame.barriers.before[0].empty() && frame.barriers.before[1].empty() && frame.barriers.after.empty());
}

TEST(Packing, AChainNeedsTwoBlocksOnly) {
  Declaration d;
  std::uint32_t last = d.image();
  d.pass({{last, Use::kStorageWriteCompute}});
  for (int i = 0; i < 20; ++i) {
    const auto next = d.image();
    d.pass({{last, Use::kSampledCompute}, {next, Use::kStorageWriteCompute}});
    last = next;
  }
  d.pass({{last, Use::kSampledCompute}}, true);
  for (const plan::Placement& p : planFrame(d.input).placements) EXPECT_LT(p.offset, 512u);  // of 21 × 256 bytes
}

TEST(Packing, BlocksAreAlignedInsideTheirHeapAndApartWhileBothLive) {
  Random random(1);
  double packed = 0, most = 0;
  for (int n = 0; n < 10'000; ++n) {
    std::vector<plan::Block> blocks(1 + random() % 40);
    for (plan::Block& b : blocks) {
      const std::uint32_t first = random() % 60;
      b = {1 + random() % 5000, 1ull << random() % 12, {first, first + random() % 12}, random() % 2};
    }
    const plan::Packing packing = plan::pack(blocks, 2);
    std::vector<std::uint64_t> load(2 * 80);  // bytes alive at each pass
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const plan::Block& a = blocks[i];
      ASSERT_EQ(packing.offsets[i] % a.alignment, 0u);
      ASSERT_LE(packing.offsets[i] + a.size, packing.heapSizes[a.heap]);
      for (std::uint32_t p = a.life.first; p <= a.life.last; ++p) load[a.heap * 80 + p] += a.size;
      for (std::size_t j = 0; j < i; ++j) {
        const plan::Block& b = blocks[j];
        const bool together = a.heap == b.heap && !(a.life.last < b.life.first || b.life.last < a.life.first);
        const bool apart =
            packing.offsets[i] + a.size <= packing.offsets[j] || packing.offsets[j] + b.size <= packing.offsets[i];
        ASSERT_TRUE(!together || apart) << "case " << n;
      }
    }
    for (std::uint32_t heap = 0; heap < 2; ++heap) {
      packed += static_cast<double>(packing.heapSizes[heap]);
      most += static_cast<double>(*std::max_element(load.begin() + heap * 80, load.begin() + heap * 80 + 80));
    }
  }
  // No packing beats the most that lives at once. First fit with these coarse alignments stays near it.
  std::printf("packed memory is %.3f of the lower bound\n", packed / most);
  EXPECT_LT(packed, 1.25 * most);
}

TEST(Mistakes, AreNamed) {
  const auto mistake = [](auto declare) {
    Declaration d;
    declare(d);
    return plan::findMistake(d.input);
  };
  EXPECT_THAT(mistake([](Declaration& d) { d.pass({{d.image(), Use::kSampledCompute}}); }), HasSubstr("nobody wrote"));
  EXPECT_THAT(mistake([](Declaration& d) { d.pass({{d.image(), Use::kColorReadWrite}}); }), HasSubstr("nobody wrote"));
  EXPECT_THAT(mistake([](Declaration& d) {
                const auto i = d.importImage(VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
                d.pass({{i, Use::kSampledCompute}});
              }),
              HasSubstr("nobody wrote"));
  EXPECT_THAT(mistake([](Declaration& d) {
                const auto i = d.image();
                d.pass({{i, Use::kColorWrite}, {i, Use::kStorageWriteCompute}});
              }),
              HasSubstr("one way only"));
  EXPECT_THAT(mistake([](Declaration& d) {
                d.pass({{d.buffer(), Use::kColorWrite}});
              }),
              HasSubstr("not a use of buffers"));
  EXPECT_THAT(mistake([](Declaration& d) {
                d.pass({{d.importImage(VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL), Use::kUniform}});
              }),
              HasSubstr("not a use of images"));
  EXPECT_THAT(mistake([](Declaration& d) { d.pass({{7, Use::kUniform}}); }), HasSubstr("does not have"));
  EXPECT_EQ(mistake([](Declaration& d) { d.pass({{d.importBuffer(), Use::kUniform}}); }), "");
}

}  // namespace
}  // namespace tyndall::render::test
