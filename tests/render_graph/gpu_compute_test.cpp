// Chains of compute passes through transients that share memory.
#include <atomic>

#include "gpu_helpers.hpp"

namespace tyndall::render::test {
namespace {

constexpr std::uint32_t kSide = 64, kCount = kSide * kSide, kSteps = 24;

constexpr const char* kStart = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { uint seed; };
layout(binding = 0, r32ui) writeonly uniform uimage2D target;
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  imageStore(target, p, uvec4(seed + uint(p.y) * 64u + uint(p.x)));
})";
constexpr const char* kToBuffer = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { uint step; };
layout(binding = 0) uniform usampler2D source;
layout(binding = 1, scalar) writeonly buffer Out { uint values[]; };
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  values[(p.y + 1) % 64 * 64 + p.x] = texelFetch(source, p, 0).r * 3u + step;   // moved down a row: all texels must be there
})";
constexpr const char* kToImage = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { uint step; };
layout(binding = 0, scalar) readonly buffer In { uint values[]; };
layout(binding = 1, r32ui) writeonly uniform uimage2D target;
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  imageStore(target, ivec2((p.x + 1) % 64, p.y), uvec4(values[p.y * 64 + p.x] * 5u ^ step));   // moved right a column
})";

// The same arithmetic on the host.
std::vector<std::uint32_t> expected(std::uint32_t seed) {
  std::vector<std::uint32_t> values(kCount), moved(kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) values[i] = seed + i;
  for (std::uint32_t step = 0; step < kSteps; ++step) {
    for (std::uint32_t i = 0; i < kCount; ++i)
      moved[(i / kSide + 1) % kSide * kSide + i % kSide] = values[i] * 3 + step;
    for (std::uint32_t i = 0; i < kCount; ++i)
      values[i / kSide * kSide + (i % kSide + 1) % kSide] = moved[i] * 5 ^ step;
  }
  return values;
}

class GraphCompute : public GraphGpuTest {
 protected:
  void SetUp() override {
    GraphGpuTest::SetUp();
    start = compute(kStart, {{0, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}}, 4);
    toBuffer = compute(kToBuffer, {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, {1}}, 4);
    toImage = compute(kToImage, {{0}, {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}}, 4);
    VkSamplerCreateInfo nearest{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    sampler = device->sampler(nearest);
  }
  void TearDown() override {
    start = {};
    toBuffer = {};
    toImage = {};
    GraphGpuTest::TearDown();
  }

  ImageRef newImage(Graph& graph, std::uint32_t step) {
    return graph.image(
        {.name = "image " + std::to_string(step), .format = VK_FORMAT_R32_UINT, .width = kSide, .height = kSide},
        "chain");
  }

  /// image -> buffer -> image ..., each step through new transients.
  ImageRef addChain(Graph& graph, std::uint32_t seed) {
    ImageRef image = newImage(graph, 0);
    graph.pass("start").use(image, Use::kStorageWriteCompute).run([this, image, seed](PassContext& c) {
      bind(c, start);
      gpu::Descriptors(c.commands(), start).storageImage(0, c.view(image)).push();
      push(c, start, seed);
      vkCmdDispatch(c.commands(), kSide / 8, kSide / 8, 1);
    });
    for (std::uint32_t step = 0; step < kSteps; ++step) {
      const BufferRef buffer = graph.buffer({.name = "buffer " + std::to_string(step), .size = kCount * 4}, "chain");
      graph.pass("to buffer", "chain")
          .use(image, Use::kSampledCompute)
          .use(buffer, Use::kStorageWriteCompute)
          .run([this, image, buffer, step](PassContext& c) {
            bind(c, toBuffer);
            gpu::Descriptors(c.commands(), toBuffer)
                .sampled(0, c.view(image), sampler)
                .storageBuffer(1, c.buffer(buffer))
                .push();
            push(c, toBuffer, step);
            vkCmdDispatch(c.commands(), kSide / 8, kSide / 8, 1);
          });
      const ImageRef next = newImage(graph, step + 1);
      graph.pass("to image", "chain")
          .use(buffer, Use::kStorageReadCompute)
          .use(next, Use::kStorageWriteCompute)
          .run([this, buffer, next, step](PassContext& c) {
            bind(c, toImage);
            gpu::Descriptors(c.commands(), toImage)
                .storageBuffer(0, c.buffer(buffer))
                .storageImage(1, c.view(next))
                .push();
            push(c, toImage, step);
            vkCmdDispatch(c.commands(), kSide / 8, kSide / 8, 1);
          });
      image = next;
    }
    return image;
  }

  gpu::Pipeline start, toBuffer, toImage;
  VkSampler sampler = VK_NULL_HANDLE;
};

TEST_F(GraphCompute, AChainThroughSharedMemoryComputesItsNumbers) {
  const gpu::Buffer result = hostBuffer(kCount * 4);
  Graph graph(*device, *memory);
  copyOut(graph, addChain(graph, 7), graph.import(result), VK_IMAGE_ASPECT_COLOR_BIT);
  compileAndRun(graph);
  EXPECT_EQ(hostValues<std::uint32_t>(result), expected(7));
  const GraphStatistics statistics = graph.statistics();
  EXPECT_EQ(statistics.passesRun, 2 * kSteps + 2);
  // 25 images and 24 buffers, of which one image and one buffer live at a time.
  EXPECT_GE(statistics.transientBytesUnshared, (2 * kSteps + 1) * kCount * 4);
  EXPECT_LE(statistics.transientBytes * 10, statistics.transientBytesUnshared);
  EXPECT_EQ(graph.ownerBytes("chain"), statistics.transientBytesUnshared);
  EXPECT_EQ(graph.ownerBytes("engine"), 0u);
  // Each with its part of the memory and the passes that need it; those that live at the same time lie apart.
  const std::vector<TransientUse> uses = graph.transients();
  EXPECT_EQ(uses.size(), 2 * kSteps + 1);
  VkDeviceSize sum = 0;
  for (const TransientUse& use : uses) {
    sum += use.bytes;
    EXPECT_EQ(use.owner, "chain");
    EXPECT_GE(use.bytes, kCount * 4);
    if (use.image) {
      EXPECT_EQ(use.image->width, kSide);
    } else {
      EXPECT_EQ(use.firstPass, "to buffer");
      EXPECT_EQ(use.lastPass, "to image");
    }
  }
  EXPECT_EQ(sum, statistics.transientBytesUnshared);
}

TEST_F(GraphCompute, AHundredFramesInFlightAgreeAndNeedNoMoreMemory) {
  constexpr std::uint32_t kFrames = 100;
  const gpu::Buffer results[2] = {hostBuffer(kCount * 4), hostBuffer(kCount * 4)};
  auto timestamps = gpu::Timestamps::create(*device, 2 * kSteps + 2);
  TY_EXPECT_OK(timestamps);
  VkDeviceSize bytes = 0;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    auto commands = device->beginFrame();  // waits for frame - 2, whose result is then complete
    TY_EXPECT_OK(commands);
    if (frame >= 2) {
      ASSERT_EQ(hostValues<std::uint32_t>(results[frame % 2]), expected(1000 * (frame - 2))) << frame;
    }
    Graph graph(*device, *memory);
    copyOut(graph, addChain(graph, 1000 * frame), graph.import(results[frame % 2]), VK_IMAGE_ASPECT_COLOR_BIT);
    TY_EXPECT_OK(graph.compile());
    graph.record(*commands, frame + 1 == kFrames ? &*timestamps : nullptr);
    TY_EXPECT_OK(device->endFrame());
    if (frame == 1) bytes = device->allocatedBytes();
    if (frame > 1) {
      ASSERT_EQ(device->allocatedBytes(), bytes) << "frame " << frame;
    }
    if (frame + 1 != kFrames) continue;
    TY_EXPECT_OK(device->waitIdle());
    const std::vector<double> times = timestamps->milliseconds();
    ASSERT_EQ(times.size(), graph.passes().size());
    EXPECT_EQ(graph.passes().front().name, "start");
    EXPECT_EQ(graph.passes()[1].owner, "chain");
    for (const double ms : times) EXPECT_GE(ms, 0);
  }
}

TEST_F(GraphCompute, ACompiledGraphMayBeRecordedAgain) {
  const gpu::Buffer result = hostBuffer(kCount * 4);
  Graph graph(*device, *memory);
  copyOut(graph, addChain(graph, 3), graph.import(result), VK_IMAGE_ASPECT_COLOR_BIT);
  compileAndRun(graph);
  std::memset(result.mapped(), 0, kCount * 4);
  TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
    graph.record(commands, nullptr);
    graph.record(commands, nullptr);
  }));
  EXPECT_EQ(hostValues<std::uint32_t>(result), expected(3));
}

TEST_F(GraphCompute, PassesNobodyNeedsAreNeitherRunNorGivenMemory) {
  std::atomic<bool> ran = false;
  Graph graph(*device, *memory);
  addChain(graph, 7);
  const ImageRef other = newImage(graph, 0);
  graph.pass("unneeded").use(other, Use::kStorageWriteCompute).run([&](PassContext&) { ran = true; });
  compileAndRun(graph);
  EXPECT_FALSE(ran);
  EXPECT_EQ(graph.statistics().passesRun, 0u);
  EXPECT_EQ(graph.statistics().transientBytes, 0u);
  EXPECT_EQ(graph.statistics().barriers, 0u);
}

TEST_F(GraphCompute, AnImageTheDeviceRefusesIsAnErrorThatNamesIt) {
  Graph graph(*device, *memory);
  const ImageRef huge = graph.image({.name = "huge", .format = VK_FORMAT_R32_UINT, .width = 1'000'000, .height = 1});
  graph.pass("write").use(huge, Use::kStorageWriteCompute).keep().run([](PassContext&) {});
  const auto refused = graph.compile();
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("huge"), std::string::npos) << refused.error().message;
  // The memory is good for the next graph.
  const gpu::Buffer result = hostBuffer(kCount * 4);
  Graph next(*device, *memory);
  copyOut(next, addChain(next, 9), next.import(result), VK_IMAGE_ASPECT_COLOR_BIT);
  compileAndRun(next);
  EXPECT_EQ(hostValues<std::uint32_t>(result), expected(9));
}

}  // namespace
}  // namespace tyndall::render::test
