// What the graph's device tests share: a readback pass and a fixture with the graph's memory.
#pragma once

#include "gpu_test.hpp"
#include "render/graph.hpp"

namespace tyndall::render::test {

using gpu::test::compile;
using gpu::test::isOk;
using gpu::test::valuesOf;

class GraphGpuTest : public gpu::test::GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    if (device) memory = std::make_unique<GraphMemory>(*device);
  }
  void TearDown() override {
    memory.reset();
    GpuTest::TearDown();
  }

  gpu::Buffer hostBuffer(VkDeviceSize bytes) {
    auto made = device->createBuffer({.name = "readback",
                                      .size = bytes,
                                      .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                                      .hostVisible = true});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
    return made.take();
  }

  gpu::Pipeline compute(const std::string& text, std::vector<gpu::Binding> bindings, std::uint32_t pushBytes = 0) {
    auto made = gpu::createPipeline(*device, gpu::ComputePipelineDesc{.name = "test",
                                                                      .shader = compile("comp", text),
                                                                      .bindings = std::move(bindings),
                                                                      .pushConstantBytes = pushBytes});
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
    return made.take();
  }

  /// Copies one layer's colour or depth texels into a buffer the host reads.
  static void copyOut(Graph& graph, ImageRef image, BufferRef target, VkImageAspectFlags aspect,
                      std::uint32_t layer = 0) {
    graph.pass("copy out")
        .use(image, Use::kTransferRead)
        .use(target, Use::kTransferWrite)
        .run([=](PassContext& context) {
          VkBufferImageCopy region{};
          region.imageSubresource = {aspect, 0, layer, 1};
          region.imageExtent = {context.desc(image).width, context.desc(image).height, 1};
          vkCmdCopyImageToBuffer(context.commands(), context.image(image), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                 context.buffer(target), 1, &region);
        });
  }

  void compileAndRun(Graph& graph) {
    const auto compiled = graph.compile();
    ASSERT_TRUE(compiled.ok()) << compiled.error().message;
    const auto done = device->submitAndWait([&](VkCommandBuffer commands) { graph.record(commands, nullptr); });
    ASSERT_TRUE(done.ok()) << done.error().message;
  }

  template <class T>
  static std::vector<T> hostValues(const gpu::Buffer& buffer) {
    std::vector<T> values(buffer.size() / sizeof(T));
    std::memcpy(values.data(), buffer.mapped(), values.size() * sizeof(T));
    return values;
  }

  std::unique_ptr<GraphMemory> memory;
};

inline void bind(PassContext& context, const gpu::Pipeline& pipeline) {
  vkCmdBindPipeline(context.commands(), pipeline.bindPoint(), pipeline.handle());
}

template <class T>
void push(PassContext& context, const gpu::Pipeline& pipeline, const T& value) {
  vkCmdPushConstants(context.commands(), pipeline.layout(), VK_SHADER_STAGE_ALL, 0, sizeof value, &value);
}

}  // namespace tyndall::render::test
