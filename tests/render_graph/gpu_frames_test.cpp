// A plan that changes from frame to frame, and our own mistakes.
#include "gpu_helpers.hpp"

namespace tyndall::render::test {
namespace {

constexpr const char* kAdd = R"(
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { uint value; };
layout(binding = 0, scalar) readonly buffer In { uint before[]; };
layout(binding = 1, scalar) writeonly buffer Out { uint after[]; };
void main() { uint i = gl_GlobalInvocationID.x; after[i] = before[i] + value; })";

class GraphFrames : public GraphGpuTest {};

// Sizes change while two frames are in flight: old memory lives until the GPU has left it, and is then given back.
TEST_F(GraphFrames, PlansOfChangingSizeStayCorrectAndGiveMemoryBack) {
  const gpu::Pipeline add = compute(kAdd, {{0}, {1}}, 4);
  gpu::Buffer results[2] = {hostBuffer(4096 * 4), hostBuffer(4096 * 4)};
  VkDeviceSize small = 0;
  for (std::uint32_t frame = 0; frame < 60; ++frame) {
    auto commands = device->beginFrame();
    TY_EXPECT_OK(commands);
    if (frame >= 2) {
      const std::uint32_t count = (frame - 2) / 5 % 2 ? 4096 : 1024;
      const auto values = hostValues<std::uint32_t>(results[frame % 2]);
      for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(values[i], (frame - 2) * 11) << "frame " << frame;
    }
    const std::uint32_t count = frame / 5 % 2 ? 4096 : 1024;
    Graph graph(*device, *memory);
    BufferRef last = graph.buffer({.name = "zero", .size = count * 4});
    graph.pass("zero").use(last, Use::kTransferWrite).run([last](PassContext& c) {
      vkCmdFillBuffer(c.commands(), c.buffer(last), 0, VK_WHOLE_SIZE, 0);
    });
    for (std::uint32_t step = 0; step < 11; ++step) {
      const BufferRef next = graph.buffer({.name = "sum " + std::to_string(step), .size = count * 4});
      graph.pass("add")
          .use(last, Use::kStorageReadCompute)
          .use(next, Use::kStorageWriteCompute)
          .run([&add, last, next, frame, count](PassContext& c) {
            bind(c, add);
            gpu::Descriptors(c.commands(), add)
                .storageBuffer(0, c.buffer(last))
                .storageBuffer(1, c.buffer(next))
                .push();
            push(c, add, frame);
            vkCmdDispatch(c.commands(), count / 64, 1, 1);
          });
      last = next;
    }
    const BufferRef out = graph.import(results[frame % 2]);
    graph.pass("copy").use(last, Use::kTransferRead).use(out, Use::kTransferWrite).run([=](PassContext& c) {
      const VkBufferCopy region{0, 0, count * 4};
      vkCmdCopyBuffer(c.commands(), c.buffer(last), c.buffer(out), 1, &region);
    });
    TY_EXPECT_OK(graph.compile());
    graph.record(*commands, nullptr);
    TY_EXPECT_OK(device->endFrame());
    if (frame == 4) small = device->allocatedBytes();
    if (frame % 10 == 4) {  // the small plan, the big one long gone
      EXPECT_EQ(device->allocatedBytes(), small) << "frame " << frame;
    }
  }
}

using GraphDeathTest = GraphFrames;

TEST_F(GraphDeathTest, OurOwnMistakesStopTheProgramByName) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto buffer = [](Graph& graph) { return graph.buffer({.name = "numbers", .size = 64}); };
  EXPECT_DEATH(
      {
        Graph graph(*device, *memory);
        graph.pass("reader").use(buffer(graph), Use::kUniform).keep().run([](PassContext&) {});
        (void)graph.compile();
      },
      "nobody wrote");
  EXPECT_DEATH(
      {
        Graph graph(*device, *memory);
        graph.pass("lazy").use(buffer(graph), Use::kTransferWrite).keep();
        (void)graph.compile();
      },
      "no run");
  EXPECT_DEATH(
      {
        Graph graph(*device, *memory);
        const BufferRef secret = buffer(graph);
        graph.pass("writer").use(secret, Use::kTransferWrite).keep().run([](PassContext&) {});
        graph.pass("thief").keep().run([secret](PassContext& c) { (void)c.buffer(secret); });
        compileAndRun(graph);
      },
      "did not declare its use of 'numbers'");
  EXPECT_DEATH(
      {
        Graph first(*device, *memory);
        Graph second(*device, *memory);
        (void)first.compile();
        (void)second.compile();
        (void)device->submitAndWait([&](VkCommandBuffer commands) { first.record(commands, nullptr); });
      },
      "another graph has compiled");
}

}  // namespace
}  // namespace tyndall::render::test
