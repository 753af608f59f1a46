// Memory and lifetimes: deferred destruction, frames in flight, churn, aliasing, refusals.
#include <chrono>
#include <cstring>
#include <functional>
#include <optional>
#include <random>
#include <thread>

#include "gpu_test.hpp"
#include "state.hpp"

namespace tyndall::gpu::test {
namespace {

class GpuLifetime : public GpuTest {};

constexpr VkBufferUsageFlags kBufferCopies = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
constexpr VkImageUsageFlags kImageCopies = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

TEST_F(GpuLifetime, OneShotSubmissionsUseTheirCommandBuffersAgain) {
  auto buffer = device->createBuffer({.name = "filled", .size = 16, .usage = kBufferCopies});
  ASSERT_TRUE(buffer.ok());
  const auto fill = [&](VkCommandBuffer commands, VkDeviceSize at, std::uint32_t value) {
    vkCmdFillBuffer(commands, buffer->handle(), at, 4, value);
  };
  for (std::uint32_t i = 0; i < 5; ++i)
    ASSERT_TRUE(device->submitAndWait([&](VkCommandBuffer commands) { fill(commands, 0, 100 + i); }));
  EXPECT_EQ(device->state().idleOneShots.size(), 1u);
  // One inside another has its own, and both are done.
  ASSERT_TRUE(device->submitAndWait([&](VkCommandBuffer outer) {
    fill(outer, 4, 7);
    EXPECT_TRUE(device->submitAndWait([&](VkCommandBuffer inner) {
      EXPECT_NE(inner, outer);
      fill(inner, 8, 8);
    }));
  }));
  EXPECT_EQ(device->state().idleOneShots.size(), 2u);
  const auto bytes = device->readback(*buffer);
  ASSERT_TRUE(bytes.ok());
  std::uint32_t values[3];
  std::memcpy(values, bytes->data(), sizeof values);
  EXPECT_EQ(values[0], 104u);
  EXPECT_EQ(values[1], 7u);
  EXPECT_EQ(values[2], 8u);
}

TEST_F(GpuLifetime, EventsAreTakenWhileTheDeviceIsWaitedFor) {
  constexpr VkDeviceSize kBytes = 64 << 20;
  auto buffer = device->createBuffer({.name = "filled", .size = kBytes, .usage = kBufferCopies});
  ASSERT_TRUE(buffer.ok());
  using Clock = std::chrono::steady_clock;
  std::vector<Clock::time_point> taken;
  device->whileWaiting([&] { taken.push_back(Clock::now()); });
  const auto work = [&](VkCommandBuffer commands) {
    for (std::uint32_t i = 0; i < 60; ++i) {
      vkCmdFillBuffer(commands, buffer->handle(), 0, kBytes, i);
      fullBarrier(commands);
    }
  };
  const auto frame = [&](auto&& wait) {
    auto commands = device->beginFrame();
    ASSERT_TRUE(commands.ok());
    work(*commands);
    ASSERT_TRUE(device->endFrame());
    ASSERT_TRUE(wait());
  };
  const std::pair<const char*, std::function<void()>> waits[] = {
      {"for frames", [&] { frame([&] { return device->waitForFrames(); }); }},
      {"for all", [&] { frame([&] { return device->waitIdle(); }); }},
      {"for one submission", [&] { ASSERT_TRUE(device->submitAndWait(work)); }}};
  for (const auto& [name, wait] : waits) {
    SCOPED_TRACE(name);
    taken.clear();
    const auto begin = Clock::now();
    wait();
    const std::chrono::duration<double> took = Clock::now() - begin;
    if (took.count() < 0.05) GTEST_SKIP() << "this device is too quick for the work of this test";
    EXPECT_GE(static_cast<double>(taken.size()), took.count() / 0.1);  // ten times a second at the very least
  }
  device->whileWaiting(nullptr);
  taken.clear();
  frame([&] { return device->waitForFrames(); });
  EXPECT_TRUE(taken.empty());
}

TEST_F(GpuLifetime, ResourcesMayGoWhileTheirFrameIsRecordedOrInFlight) {
  auto target = device->createBuffer({.name = "target", .size = 1 << 16, .usage = kBufferCopies});
  ASSERT_TRUE(target.ok());
  const VkDeviceSize start = device->allocatedBytes();
  const auto shader =
      compile("comp", "layout(local_size_x = 1) in; layout(binding = 0) buffer B { uint n; }; void main() { n = 1; }");
  for (std::uint32_t frame = 0; frame < 6; ++frame) {
    auto commands = device->beginFrame();
    ASSERT_TRUE(commands.ok());
    auto pipeline = createPipeline(*device, ComputePipelineDesc{.name = "brief", .shader = shader, .bindings = {{0}}});
    auto written = device->createBuffer({.name = "written", .size = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    auto image = device->createImage(
        {.name = "brief", .format = VK_FORMAT_R8G8B8A8_UNORM, .width = 64, .height = 64, .usage = kImageCopies});
    auto timestamps = Timestamps::create(*device, 1);
    ASSERT_TRUE(pipeline.ok() && written.ok() && image.ok() && timestamps.ok());
    timestamps->begin(*commands);
    vkCmdBindPipeline(*commands, pipeline->bindPoint(), pipeline->handle());
    Descriptors(*commands, *pipeline).storageBuffer(0, written->handle()).push();
    vkCmdDispatch(*commands, 1, 1, 1);
    transition(*commands, *image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    const VkBufferImageCopy copy{0, 0, 0, {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1}, {}, {64, 64, 1}};
    vkCmdCopyImageToBuffer(*commands, image->handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target->handle(), 1,
                           &copy);
    timestamps->mark(*commands);
    if (frame % 2) *image = Image();  // some before the submission, the rest after it, at the end of this block
    TY_EXPECT_OK(device->endFrame());
    EXPECT_GT(device->allocatedBytes(), start) << "freed while the GPU may use it";
  }
  EXPECT_EQ(device->submittedFrames(), 6u);
  TY_EXPECT_OK(device->waitIdle());
  EXPECT_EQ(device->allocatedBytes(), start);
}

TEST_F(GpuLifetime, ResourcesMayGoInsideAOneShotSubmission) {
  auto target = device->createBuffer({.name = "target", .size = 256, .usage = kBufferCopies});
  ASSERT_TRUE(target.ok());
  const VkDeviceSize start = device->allocatedBytes();
  TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
    {
      auto source = device->createBuffer({.name = "source", .size = 256, .usage = kBufferCopies});
      ASSERT_TRUE(source.ok());
      const VkBufferCopy copy{0, 0, 256};
      vkCmdFillBuffer(commands, source->handle(), 0, 256, 0);
      fullBarrier(commands);
      vkCmdCopyBuffer(commands, source->handle(), target->handle(), 1, &copy);
    }
    TY_EXPECT_OK(device->submitAndWait([](VkCommandBuffer inner) { fullBarrier(inner); }));
  }));
  EXPECT_EQ(device->allocatedBytes(), start);
}

TEST_F(GpuLifetime, AnAbandonedFrameIsBegunAgain) {
  const VkDeviceSize start = device->allocatedBytes();
  for (int i = 0; i < 3; ++i) {
    auto commands = device->beginFrame();
    ASSERT_TRUE(commands.ok());
    auto buffer = device->createBuffer({.name = "b", .size = 256, .usage = kBufferCopies});
    ASSERT_TRUE(buffer.ok());
    vkCmdFillBuffer(*commands, buffer->handle(), 0, 256, 0);
  }
  TY_EXPECT_OK(device->endFrame());
  TY_EXPECT_OK(device->waitIdle());
  EXPECT_EQ(device->submittedFrames(), 1u);
  EXPECT_EQ(device->allocatedBytes(), start);
}

TEST_F(GpuLifetime, ChurnReturnsToTheStart) {
  const VkDeviceSize start = device->allocatedBytes();
  std::mt19937 engine(3);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  {
    std::vector<Image> images;
    std::vector<Buffer> buffers;
    for (int step = 0; step < 400; ++step) {
      if (random() % 2) {
        auto made = device->createImage({.name = "churn",
                                         .format = VK_FORMAT_R8G8B8A8_UNORM,
                                         .width = 1 + random() % 700,
                                         .height = 1 + random() % 700,
                                         .usage = kImageCopies});
        ASSERT_TRUE(made.ok()) << made.error().message;
        images.push_back(made.take());
      } else {
        auto made = device->createBuffer({.name = "churn",
                                          .size = 1 + random() % 3000000,
                                          .usage = kBufferCopies,
                                          .hostVisible = random() % 2 == 0});
        ASSERT_TRUE(made.ok()) << made.error().message;
        if (made->mapped()) std::memset(made->mapped(), 1, 1);
        buffers.push_back(made.take());
      }
      if (images.size() > 30)
        images[random() % images.size()] = images[random() % 2] ? std::move(images.back()) : Image();
      if (images.size() > 30) std::erase_if(images, [&](const Image& image) { return !image || random() % 2; });
      if (buffers.size() > 30) std::erase_if(buffers, [&](const Buffer&) { return random() % 2 == 0; });
    }
    EXPECT_GT(device->allocatedBytes(), start);
  }
  EXPECT_EQ(device->allocatedBytes(), start);
}

TEST_F(GpuLifetime, MovedFromObjectsAreEmptyAndTheTargetLetsGo) {
  const VkDeviceSize start = device->allocatedBytes();
  auto a = device->createBuffer({.name = "a", .size = 4096, .usage = kBufferCopies});
  const VkDeviceSize one = device->allocatedBytes() - start;
  auto b = device->createBuffer({.name = "b", .size = 4096, .usage = kBufferCopies});
  ASSERT_TRUE(a.ok() && b.ok());
  Buffer kept = a.take();
  EXPECT_FALSE(*a);
  kept = b.take();
  EXPECT_TRUE(kept);
  EXPECT_EQ(device->allocatedBytes() - start, one);
  Buffer& same = kept;
  kept = std::move(same);
  EXPECT_TRUE(kept);
  kept = Buffer();
  EXPECT_EQ(device->allocatedBytes(), start);
}

TEST_F(GpuLifetime, AnAbsurdImageOrBufferIsRefusedInOneLine) {
  const VkDeviceSize start = device->allocatedBytes();
  const std::uint32_t most = device->info().limits.maxImageDimension2D;
  const ImageDesc absurd[] = {
      {.name = "wide", .format = VK_FORMAT_R8G8B8A8_UNORM, .width = 2'000'000'000, .height = 3, .usage = kImageCopies},
      {.name = "zero", .format = VK_FORMAT_R8G8B8A8_UNORM, .width = 0, .height = 3, .usage = kImageCopies},
      {.name = "mips", .format = VK_FORMAT_R8G8B8A8_UNORM, .width = 4, .height = 4, .mips = 9, .usage = kImageCopies},
      {.name = "layers",
       .format = VK_FORMAT_R8G8B8A8_UNORM,
       .width = 4,
       .height = 4,
       .layers = 1u << 30,
       .usage = kImageCopies},
      {.name = "format",
       .format = VK_FORMAT_R8G8B8A8_SRGB,
       .width = 4,
       .height = 4,
       .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT},
      {.name = "heavy",
       .format = VK_FORMAT_R32G32B32A32_SFLOAT,
       .width = most,
       .height = most,
       .layers = 512,
       .usage = kImageCopies}};
  for (const ImageDesc& desc : absurd) {
    auto image = device->createImage(desc);
    ASSERT_FALSE(image.ok()) << desc.name;
    EXPECT_NE(image.error().message.find("'" + desc.name + "'"), std::string::npos) << image.error().message;
    EXPECT_EQ(image.error().message.find('\n'), std::string::npos);
  }
  for (const VkDeviceSize size : {VkDeviceSize{0}, VkDeviceSize{1} << 50, ~VkDeviceSize{0}}) {
    auto buffer = device->createBuffer({.name = "absurd", .size = size, .usage = kBufferCopies});
    ASSERT_FALSE(buffer.ok()) << size;
    EXPECT_NE(buffer.error().message.find("'absurd'"), std::string::npos) << buffer.error().message;
  }
  EXPECT_FALSE(device->allocate(device->requirements(absurd[0]), "absurd").ok());
  EXPECT_EQ(device->allocatedBytes(), start);
}

TEST_F(GpuLifetime, WhenMemoryEndsThatIsAnErrorAndNotTheEnd) {
  const VkDeviceSize start = device->allocatedBytes();
  {
    std::vector<Buffer> buffers;
    std::string refusal;
    for (int i = 0; i < 20000 && refusal.empty(); ++i) {
      auto made = device->createBuffer({.name = "hog", .size = VkDeviceSize{1} << 28, .usage = kBufferCopies});
      if (made)
        buffers.push_back(made.take());
      else
        refusal = made.error().message;
    }
    EXPECT_NE(refusal.find("'hog'"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("268435456 bytes"), std::string::npos) << refusal;
    EXPECT_GT(buffers.size(), 0u);
  }
  EXPECT_EQ(device->allocatedBytes(), start);
  TY_EXPECT_OK(device->createBuffer({.name = "after", .size = 1 << 20, .usage = kBufferCopies}));
}

TEST_F(GpuLifetime, ImagesAndBuffersShareMemoryInTurn) {
  const VkDeviceSize start = device->allocatedBytes();
  const ImageDesc imageDesc{
      .name = "shared image", .format = VK_FORMAT_R32_SFLOAT, .width = 65, .height = 33, .usage = kImageCopies};
  const BufferDesc bufferDesc{.name = "shared buffer", .size = 5000, .usage = kBufferCopies};
  auto needs = device->requirements(imageDesc);
  const auto bufferNeeds = device->requirements(bufferDesc);
  needs.size = std::max(needs.size, bufferNeeds.size) * 2;
  needs.alignment = std::max(needs.alignment, bufferNeeds.alignment);
  needs.memoryTypeBits &= bufferNeeds.memoryTypeBits;
  auto memory = device->allocate(needs, "shared");
  ASSERT_TRUE(memory.ok()) << memory.error().message;
  const VkDeviceSize held = device->allocatedBytes();
  EXPECT_GE(held - start, needs.size);
  {
    auto image = device->createImageAt(imageDesc, *memory, 0);
    auto buffer = device->createBufferAt(bufferDesc, *memory, needs.size / 2 / needs.alignment * needs.alignment);
    ASSERT_TRUE(image.ok() && buffer.ok());
    EXPECT_EQ(device->allocatedBytes(), held);
    *memory = nullptr;
    EXPECT_EQ(device->allocatedBytes(), held) << "the image and the buffer still lie there";
    const std::vector<float> texels(65 * 33, 2.5f);
    const std::vector<std::uint8_t> bytes(5000, 9);
    TY_EXPECT_OK(device->upload(*image, bytesOf(texels)));
    TY_EXPECT_OK(device->upload(*buffer, bytesOf(bytes)));
    EXPECT_EQ(valuesOf<float>(*device->readback(*image, VK_IMAGE_LAYOUT_GENERAL)), texels);
    EXPECT_EQ(valuesOf<std::uint8_t>(*device->readback(*buffer)), bytes);
  }
}

TEST_F(GpuLifetime, ASiblingComputesOnAnotherThreadBesideFrames) {
  const auto shader =
      compile("comp", "layout(local_size_x = 1) in; layout(binding = 0) buffer B { uint n; }; void main() { n = 7; }");
  std::vector<std::uint32_t> got;
  std::optional<Pipeline> forUs;
  std::thread other([&] {
    auto sibling = device->createSibling();
    ASSERT_TRUE(sibling.ok()) << sibling.error().message;
    const ComputePipelineDesc desc{.name = "sibling's", .shader = shader, .bindings = {{0}}};
    auto buffer = (*sibling)->createBuffer(
        {.name = "sibling's", .size = 4, .usage = kBufferCopies | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    auto pipeline = createPipeline(**sibling, desc);
    ASSERT_TRUE(buffer.ok() && pipeline.ok());
    const auto done = (*sibling)->submitAndWait([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, pipeline->bindPoint(), pipeline->handle());
      Descriptors(commands, *pipeline).storageBuffer(0, buffer->handle()).push();
      vkCmdDispatch(commands, 1, 1, 1);
      fullBarrier(commands);
    });
    ASSERT_TRUE(done.ok()) << done.error().message;
    got = valuesOf<std::uint32_t>(*(*sibling)->readback(*buffer));
    auto made = createPipeline(*device, desc);  // on a thread that does not own the device
    ASSERT_TRUE(made.ok());
    forUs.emplace(made.take());
  });
  for (int frame = 0; frame < 50; ++frame) {
    auto commands = device->beginFrame();
    TY_EXPECT_OK(commands);
    auto brief = device->createBuffer({.name = "brief", .size = 64, .usage = kBufferCopies});
    TY_EXPECT_OK(brief);
    TY_EXPECT_OK(device->endFrame());
  }
  other.join();
  EXPECT_EQ(got, std::vector<std::uint32_t>{7});
  EXPECT_TRUE(forUs && *forUs);
}

TEST_F(GpuLifetime, DestroyNowFreesWhatTheFrameBeingRecordedLetGo) {
  const VkDeviceSize start = device->allocatedBytes();
  auto commands = device->beginFrame();
  TY_EXPECT_OK(commands);
  auto first = device->createBuffer({.name = "first", .size = 1 << 20, .usage = kBufferCopies});
  auto second = device->createBuffer({.name = "second", .size = 1 << 20, .usage = kBufferCopies});
  ASSERT_TRUE(first.ok() && second.ok());
  *first = Buffer();
  EXPECT_GT(device->allocatedBytes(), start + (1 << 20)) << "it waits for the frame";
  TY_EXPECT_OK(device->destroyNow([&] { *second = Buffer(); }));
  EXPECT_EQ(device->allocatedBytes(), start);
  TY_EXPECT_OK(device->endFrame());
}

TEST(GpuLifetimeDeathTest, AResourceThatOutlivesItsDeviceIsABug) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(
      {
        auto device = Device::create({});
        auto buffer = (*device)->createBuffer({.name = "orphan", .size = 4, .usage = kBufferCopies});
        device->reset();
      },
      "outlive.*orphan");
}

}  // namespace
}  // namespace tyndall::gpu::test
