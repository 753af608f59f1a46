// Barriers by hand: one small graph per rule.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frames.hpp"

namespace tyndall::render::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
constexpr VkPipelineStageFlags2 kGraphics =
    VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
constexpr VkPipelineStageFlags2 kColor = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkPipelineStageFlags2 kTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkPipelineStageFlags2 kAll = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
constexpr VkAccessFlags2 kStorageWrite = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
constexpr VkAccessFlags2 kStorageRead = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
constexpr VkAccessFlags2 kShaderRead = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | kStorageRead;
constexpr VkAccessFlags2 kColorWrite = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 kColorAll = kColorWrite | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT;
constexpr VkAccessFlags2 kDepthWrite = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
constexpr VkAccessFlags2 kDepthRead = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
constexpr std::uint32_t kMemory = plan::Barrier::kMemory;
constexpr VkImageLayout kUndefined = VK_IMAGE_LAYOUT_UNDEFINED, kGeneral = VK_IMAGE_LAYOUT_GENERAL,
                        kReadOnly = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                        kColorLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                        kDepthLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
                        kDepthReadLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;

TEST(Barriers, ReadAfterWrite) {
  Declaration d;
  const auto b = d.buffer();
  d.pass({{b, Use::kStorageWriteCompute}});
  d.pass({{b, Use::kIndirect}}, true);
  EXPECT_THAT(planFrame(d.input).barriers.before[1],
              ElementsAre(plan::Barrier{kMemory, kCompute, kStorageWrite, VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT,
                                        VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT}));
}

TEST(Barriers, WriteAfterReadWaitsWithoutFlush) {
  Declaration d;
  const auto b = d.buffer();
  d.pass({{b, Use::kStorageWriteCompute}});
  d.pass({{b, Use::kUniform}}, true);
  d.pass({{b, Use::kTransferWrite}}, true);
  EXPECT_THAT(planFrame(d.input).barriers.before[2],
              ElementsAre(plan::Barrier{kMemory, kGraphics | kCompute, 0, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                        VK_ACCESS_2_TRANSFER_WRITE_BIT}));
}

TEST(Barriers, WriteAfterWrite) {
  Declaration d;
  const auto i = d.image(false);
  d.pass({{i, Use::kStorageWriteCompute}}, true);
  d.pass({{i, Use::kStorageWriteCompute}}, true);
  EXPECT_THAT(planFrame(d.input).barriers.before[1],
              ElementsAre(plan::Barrier{i, kCompute, kStorageWrite, kCompute, kStorageWrite, kGeneral, kGeneral}));
}

TEST(Barriers, ReadAfterReadNeedsNoneAndTheFirstServesAll) {
  Declaration d;
  const auto i = d.image();
  d.pass({{i, Use::kStorageWriteCompute}});
  d.pass({{i, Use::kSampledCompute}}, true);
  d.pass({{i, Use::kSampledGraphics}}, true);
  d.pass({{i, Use::kSampledCompute}}, true);
  const plan::Barriers barriers = planFrame(d.input).barriers;
  EXPECT_THAT(barriers.before[1], ElementsAre(plan::Barrier{i, kCompute, kStorageWrite, kCompute | kGraphics,
                                                            kShaderRead, kGeneral, kReadOnly}));
  EXPECT_THAT(barriers.before[2], IsEmpty());
  EXPECT_THAT(barriers.before[3], IsEmpty());
}

TEST(Barriers, LayoutChangeBetweenReadsWaitsForTheReaders) {
  Declaration d;
  const auto i = d.image();
  d.pass({{i, Use::kColorWrite}});
  d.pass({{i, Use::kSampledGraphics}}, true);
  d.pass({{i, Use::kTransferRead}}, true);
  const plan::Barriers barriers = planFrame(d.input).barriers;
  EXPECT_THAT(barriers.before[1],
              ElementsAre(plan::Barrier{i, kColor, kColorWrite, kGraphics, kShaderRead, kColorLayout, kReadOnly}));
  EXPECT_THAT(barriers.before[2], ElementsAre(plan::Barrier{i, kGraphics, 0, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                                            VK_ACCESS_2_TRANSFER_READ_BIT, kReadOnly,
                                                            VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL}));
}

TEST(Barriers, LoadedAttachmentsSeeWhatWasThere) {
  Declaration d;
  const auto color = d.image(), depth = d.image();
  d.pass({{color, Use::kColorWrite}, {depth, Use::kDepthWrite}});
  d.pass({{color, Use::kColorReadWrite}, {depth, Use::kDepthRead}}, true);
  d.pass({{depth, Use::kDepthReadWrite}}, true);
  const plan::Barriers barriers = planFrame(d.input).barriers;
  EXPECT_THAT(
      barriers.before[1],
      ElementsAre(plan::Barrier{color, kColor, kColorWrite, kColor, kColorAll, kColorLayout, kColorLayout},
                  plan::Barrier{depth, kTests, kDepthWrite, kTests, kDepthRead, kDepthLayout, kDepthReadLayout}));
  EXPECT_THAT(barriers.before[2], ElementsAre(plan::Barrier{depth, kTests, 0, kTests, kDepthRead | kDepthWrite,
                                                            kDepthReadLayout, kDepthLayout}));
}

// What the last frame left in the same memory comes before this frame's first write: here the image's own last read.
TEST(Barriers, FirstUseWaitsForTheLastFrame) {
  Declaration d;
  const auto i = d.image();
  d.pass({{i, Use::kColorWrite}});
  d.pass({{i, Use::kSampledCompute}}, true);
  EXPECT_THAT(planFrame(d.input).barriers.before[0],
              ElementsAre(plan::Barrier{i, kCompute, 0, kColor, kColorAll, kUndefined, kColorLayout}));
}

TEST(Barriers, MemoryThatChangesHandsIsFlushedForAll) {
  Declaration d;
  const auto a = d.image(), b = d.image();
  d.pass({{a, Use::kStorageWriteCompute}}, true);
  d.pass({{b, Use::kColorWrite}}, true);
  const Frame frame = planFrame(d.input);
  ASSERT_TRUE(frame.placements[0].overlaps(frame.placements[1]));
  // The image barrier reaches only writes through b; those through a need the global one. Sources: a's and b's last
  // uses.
  EXPECT_THAT(frame.barriers.before[1],
              ElementsAre(plan::Barrier{kMemory, kCompute | kColor, kStorageWrite | kColorWrite, kColor, kColorAll},
                          plan::Barrier{b, kCompute | kColor, kStorageWrite | kColorWrite, kColor, kColorAll,
                                        kUndefined, kColorLayout}));
}

TEST(Barriers, ImportsWaitForEverythingAndAreHandedBack) {
  Declaration d;
  const auto screen = d.importImage(kUndefined, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
  const auto kept = d.importImage(kReadOnly, kReadOnly);
  const auto readback = d.importBuffer(true);
  const auto unused = d.importImage(kUndefined, kGeneral);
  d.pass({{screen, Use::kColorWrite}, {kept, Use::kSampledGraphics}, {readback, Use::kStorageWriteCompute}});
  const plan::Barriers barriers = planFrame(d.input).barriers;
  constexpr VkAccessFlags2 kAnyWrite = VK_ACCESS_2_MEMORY_WRITE_BIT, kAny = kAnyWrite | VK_ACCESS_2_MEMORY_READ_BIT;
  EXPECT_THAT(barriers.before[0],
              ElementsAre(plan::Barrier{screen, kAll, kAnyWrite, kColor, kColorAll, kUndefined, kColorLayout},
                          plan::Barrier{kept, kAll, kAnyWrite, kGraphics, kShaderRead, kReadOnly, kReadOnly},
                          plan::Barrier{kMemory, kAll, kAnyWrite, kCompute, kStorageWrite}));
  EXPECT_THAT(
      barriers.after,
      ElementsAre(plan::Barrier{screen, kColor, kColorWrite, kAll, kAny, kColorLayout, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR},
                  plan::Barrier{kMemory, kCompute, kStorageWrite, kAll | VK_PIPELINE_STAGE_2_HOST_BIT,
                                kAny | VK_ACCESS_2_HOST_READ_BIT},
                  plan::Barrier{unused, kAll, kAnyWrite, kAll, kAny, kUndefined, kGeneral}));
}

}  // namespace
}  // namespace tyndall::render::test
