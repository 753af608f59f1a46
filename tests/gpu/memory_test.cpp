// The allocator's blocks on a real device: few, shared, returned.
#include <map>
#include <random>

#include "gpu_test.hpp"
#include "memory.hpp"

namespace tyndall::gpu::test {
namespace {

class GpuMemory : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    if (device) allocator = std::make_unique<Allocator>(device->physical(), device->handle());
  }
  void TearDown() override {
    allocator.reset();
    GpuTest::TearDown();
  }
  std::shared_ptr<Allocation> take(VkDeviceSize size, MemoryUse use = MemoryUse::kDevice,
                                   VkDeviceSize alignment = 256) {
    auto made = allocator->allocate({size, alignment, ~0u}, use, "test");
    EXPECT_TRUE(made.ok()) << made.error().message;
    return made.ok() ? made.take() : nullptr;
  }
  std::unique_ptr<Allocator> allocator;
};

constexpr VkDeviceSize kMiB = 1 << 20;

TEST_F(GpuMemory, SmallRequestsShareABlockAndBigOnesHaveTheirOwn) {
  std::vector<std::shared_ptr<Allocation>> held;
  for (int i = 0; i < 50; ++i) held.push_back(take(kMiB));
  EXPECT_EQ(allocator->blockCount(), 1u);
  EXPECT_EQ(allocator->usedBytes(), 50 * kMiB);
  held.push_back(take(80 * kMiB));
  EXPECT_EQ(allocator->blockCount(), 2u);
  held.pop_back();
  EXPECT_EQ(allocator->blockCount(), 1u) << "a big request's own block goes with it";
  held.clear();
  EXPECT_EQ(allocator->usedBytes(), 0u);
}

TEST_F(GpuMemory, RangesDoNotOverlapAndChurnLeavesAtMostOneEmptyBlock) {
  std::mt19937 engine(11);
  for (int round = 0; round < 3; ++round) {
    std::vector<std::shared_ptr<Allocation>> held;
    for (int step = 0; step < 1500; ++step) {
      if (engine() % 3) {
        held.push_back(take(1 + engine() % (2 * kMiB), MemoryUse::kDevice, VkDeviceSize{1} << engine() % 14));
      } else if (!held.empty()) {
        held.erase(held.begin() + static_cast<std::ptrdiff_t>(engine() % held.size()));
      }
      if (held.size() > 200) held.resize(100);
    }
    for (const auto& a : held)
      for (const auto& b : held)
        ASSERT_TRUE(a == b || a->memory != b->memory || a->offset + a->size <= b->offset ||
                    b->offset + b->size <= a->offset);
    VkDeviceSize sum = 0;
    for (const auto& a : held) sum += a->size;
    EXPECT_EQ(allocator->usedBytes(), sum);
    EXPECT_GT(allocator->blockCount(), 1u);
    held.clear();
    EXPECT_EQ(allocator->usedBytes(), 0u);
    EXPECT_EQ(allocator->blockCount(), 1u) << "round " << round;
  }
}

TEST_F(GpuMemory, WhatTheHostUsesIsMapped) {
  for (const MemoryUse use : {MemoryUse::kUpload, MemoryUse::kReadback}) {
    const auto first = take(kMiB, use), second = take(kMiB, use);
    ASSERT_TRUE(first->mapped && second->mapped);
    std::memset(first->mapped, 1, kMiB);
    std::memset(second->mapped, 2, kMiB);
    EXPECT_EQ(first->mapped[kMiB - 1], std::byte{1});
  }
}

TEST_F(GpuMemory, TheHeapIsNotExceeded) {
  VkPhysicalDeviceMemoryProperties memory{};
  vkGetPhysicalDeviceMemoryProperties(device->physical(), &memory);
  VkDeviceSize largest = 0;
  for (std::uint32_t i = 0; i < memory.memoryHeapCount; ++i) largest = std::max(largest, memory.memoryHeaps[i].size);
  auto made = allocator->allocate({largest + 1, 256, ~0u}, MemoryUse::kDevice, "everything");
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().message.find("'everything'"), std::string::npos) << made.error().message;
  EXPECT_EQ(allocator->blockCount(), 0u);
}

TEST_F(GpuMemory, UsersAreNamedAndTheirBytesAreAllThatIsAllocated) {
  const auto users = [&] {
    std::map<std::string, MemoryUser> byName;
    VkDeviceSize sum = 0, last = ~VkDeviceSize{0};
    for (const MemoryUser& user : device->memoryUsers()) {
      byName[user.name] = user;
      sum += user.bytes;
      EXPECT_LE(user.bytes, last) << "the largest first";
      last = user.bytes;
    }
    EXPECT_EQ(sum, device->allocatedBytes());
    return byName;
  };
  const std::size_t before = users().size();
  const ImageDesc desc{.name = "a map",
                       .format = VK_FORMAT_R32_SFLOAT,
                       .width = 300,
                       .height = 200,
                       .usage = VK_IMAGE_USAGE_SAMPLED_BIT};
  auto image = device->createImage(desc);
  auto buffer = device->createBuffer({.name = "a list", .size = 12345, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  auto shared = device->allocate(device->requirements(desc), "in turn");
  ASSERT_TRUE(image && buffer && shared);
  auto now = users();
  ASSERT_EQ(now.size(), before + 3);
  ASSERT_TRUE(now.at("a map").image.has_value());
  EXPECT_EQ(*now.at("a map").image, desc);
  EXPECT_GE(now.at("a map").bytes, 300u * 200 * 4);
  EXPECT_FALSE(now.at("a list").image);
  EXPECT_GE(now.at("a list").bytes, 12345u);
  EXPECT_TRUE(now.at("in turn").shared);
  EXPECT_FALSE(now.at("a map").shared || now.at("a list").shared);
  // Let go of; the GPU may still use it until its frames are done.
  *image = Image();
  *shared = nullptr;
  ASSERT_TRUE(device->waitIdle());
  now = users();
  EXPECT_FALSE(now.contains("a map") || now.contains("in turn"));
  EXPECT_TRUE(now.contains("a list"));
}

}  // namespace
}  // namespace tyndall::gpu::test
