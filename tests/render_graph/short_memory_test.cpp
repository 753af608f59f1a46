// A new plan that has no room beside the old one, and one that has no room at all.
#include "gpu_helpers.hpp"

namespace tyndall::render::test {
namespace {

PFN_vkAllocateMemory allocateMemory = nullptr;
int refusals = 0;  // of the requests to come

VKAPI_ATTR VkResult VKAPI_CALL allocateOrRefuse(VkDevice device, const VkMemoryAllocateInfo* info,
                                                const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory) {
  if (refusals > 0) return --refusals, VK_ERROR_OUT_OF_DEVICE_MEMORY;
  return allocateMemory(device, info, callbacks, memory);
}

class ShortMemory : public GraphGpuTest {
 protected:
  void SetUp() override {
    GraphGpuTest::SetUp();
    allocateMemory = vkAllocateMemory, vkAllocateMemory = allocateOrRefuse;
    refusals = 0;
  }
  void TearDown() override {
    vkAllocateMemory = allocateMemory;
    GraphGpuTest::TearDown();
  }
  static constexpr std::uint32_t kLarge = 4096;  // 64 MiB: a block of memory of its own

  /// One frame in flight like the editor's: fills an image of `side` squared and reads its first row.
  Result<void> frame(std::uint32_t side, float value, const gpu::Buffer& row) {
    auto commands = device->beginFrame();
    if (!commands) return commands.error();
    Graph graph(*device, *memory);
    const ImageRef image =
        graph.image({.name = "large", .format = VK_FORMAT_R32_SFLOAT, .width = side, .height = side});
    const BufferRef target = graph.import(row);
    graph.pass("clear").use(image, Use::kTransferWrite).run([=](PassContext& c) {
      const VkClearColorValue color{{value, 0, 0, 0}};
      const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
      vkCmdClearColorImage(c.commands(), c.image(image), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &color, 1, &all);
    });
    graph.pass("read").use(image, Use::kTransferRead).use(target, Use::kTransferWrite).run([=](PassContext& c) {
      VkBufferImageCopy region{};
      region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
      region.imageExtent = {4, 1, 1};
      vkCmdCopyImageToBuffer(c.commands(), c.image(image), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, c.buffer(target), 1,
                             &region);
    });
    auto compiled = graph.compile();
    if (compiled) {
      waited = graph.statistics().waitedForMemory;
      graph.record(*commands, nullptr);
    }
    if (auto ended = device->endFrame(); !ended) return ended;
    return compiled;
  }
  bool waited = false;
};

TEST_F(ShortMemory, TheOldImagesGoFirstWhenBothHaveNoRoom) {
  const gpu::Buffer first = hostBuffer(16), second = hostBuffer(16);
  TY_EXPECT_OK(frame(kLarge / 2, 3, first));
  const VkDeviceSize small = device->allocatedBytes();
  refusals = 1;
  TY_EXPECT_OK(frame(kLarge, 5, second));  // the first frame may still be running
  EXPECT_TRUE(waited);
  EXPECT_EQ(refusals, 0);
  EXPECT_EQ(device->allocatedBytes(), small + VkDeviceSize{4} * kLarge * kLarge * 3 / 4)
      << "the old ones are gone already";
  TY_EXPECT_OK(device->waitIdle());
  EXPECT_EQ(hostValues<float>(first)[0], 3);
  EXPECT_EQ(hostValues<float>(second)[0], 5);
  TY_EXPECT_OK(frame(kLarge, 6, second));
  EXPECT_FALSE(waited);
}

TEST_F(ShortMemory, WhatHasNoRoomAtAllIsAnErrorAndTheOldPlanComesBack) {
  const gpu::Buffer row = hostBuffer(16);
  TY_EXPECT_OK(frame(kLarge / 2, 3, row));
  const VkDeviceSize before = device->allocatedBytes();
  refusals = 2;
  const auto refused = frame(kLarge, 5, row);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("no memory"), std::string::npos) << refused.error().message;
  TY_EXPECT_OK(frame(kLarge / 2, 7, row));
  TY_EXPECT_OK(device->waitIdle());
  EXPECT_EQ(hostValues<float>(row)[0], 7);
  EXPECT_EQ(device->allocatedBytes(), before);
}

}  // namespace
}  // namespace tyndall::render::test
