// Times of passes, as ratios: compute and graphics.
#include <numeric>

#include "gpu_test.hpp"

namespace tyndall::gpu::test {
namespace {

class GpuTimestamps : public GpuTest {};

constexpr const char* kWork = R"(
layout(local_size_x = 64) in;
layout(push_constant, scalar) uniform Push { uint rounds; };
layout(binding = 0, scalar) buffer B { float values[]; };
void main() {
  float v = float(gl_GlobalInvocationID.x);
  for (uint i = 0; i < rounds; ++i) v = sin(v) * 1.5 + 0.5;
  values[gl_GlobalInvocationID.x] = v;
}
)";

TEST_F(GpuTimestamps, MoreWorkTakesLongerAndTheSpansAddUp) {
  auto buffer =
      device->createBuffer({.name = "work", .size = 64 * 64 * 4, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  auto pipeline = createPipeline(
      *device,
      ComputePipelineDesc{.name = "work", .shader = compile("comp", kWork), .bindings = {{0}}, .pushConstantBytes = 4});
  auto spans = Timestamps::create(*device, 3), whole = Timestamps::create(*device, 1);
  ASSERT_TRUE(buffer.ok() && pipeline.ok() && spans.ok() && whole.ok());
  EXPECT_EQ(spans->capacity(), 3u);
  EXPECT_TRUE(spans->milliseconds().empty());
  const std::uint32_t rounds[] = {200, 4000, 200};
  for (int frame = 0; frame < 2; ++frame) {  // the first pays for compilation
    TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
      whole->begin(commands);
      spans->begin(commands);
      for (const std::uint32_t n : rounds) {
        vkCmdBindPipeline(commands, pipeline->bindPoint(), pipeline->handle());
        Descriptors(commands, *pipeline).storageBuffer(0, buffer->handle()).push();
        vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_ALL, 0, 4, &n);
        vkCmdDispatch(commands, 64, 1, 1);
        spans->mark(commands);
      }
      whole->mark(commands);
    }));
  }
  const auto ms = spans->milliseconds();
  ASSERT_EQ(ms.size(), 3u);
  EXPECT_GT(ms[1], 4 * ms[0]);
  EXPECT_GT(ms[1], 4 * ms[2]);
  const double sum = std::accumulate(ms.begin(), ms.end(), 0.0), total = whole->milliseconds().at(0);
  EXPECT_LE(sum, total);
  EXPECT_GT(sum, 0.9 * total);
}

TEST_F(GpuTimestamps, GraphicsPassesKeepTheirOwnTime) {
  // On lavapipe a graphics pass's time lands on a later pass unless a barrier follows the timestamp: the dear pass
  // comes between two cheap ones and must not lend them its time.
  constexpr std::uint32_t kSize = 128;
  auto image = device->createImage({.name = "target",
                                    .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                    .width = kSize,
                                    .height = kSize,
                                    .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT});
  GraphicsPipelineDesc desc{.name = "dear", .pushConstantBytes = 4, .colors = {{VK_FORMAT_R32G32B32A32_SFLOAT}}};
  desc.vertex = compile(
      "vert", "void main() { gl_Position = vec4(gl_VertexIndex == 1 ? 3 : -1, gl_VertexIndex == 2 ? 3 : -1, 0, 1); }");
  desc.fragment = compile("frag", R"(
layout(push_constant, scalar) uniform Push { uint rounds; };
layout(location = 0) out vec4 target;
void main() {
  float v = gl_FragCoord.x;
  for (uint i = 0; i < rounds; ++i) v = sin(v) * 1.5 + 0.5;
  target = vec4(v);
})");
  auto pipeline = createPipeline(*device, desc);
  auto spans = Timestamps::create(*device, 3);
  ASSERT_TRUE(image.ok() && pipeline.ok() && spans.ok());
  for (int frame = 0; frame < 2; ++frame) {
    TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
      transition(commands, *image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
      spans->begin(commands);
      for (const std::uint32_t rounds : {50u, 2000u, 50u}) {
        VkRenderingAttachmentInfo target{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        target.imageView = image->view();
        target.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        target.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        target.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
        info.renderArea = {{0, 0}, {kSize, kSize}};
        info.layerCount = 1;
        info.colorAttachmentCount = 1, info.pColorAttachments = &target;
        vkCmdBeginRendering(commands, &info);
        const VkViewport viewport{0, 0, kSize, kSize, 0, 1};
        vkCmdSetViewport(commands, 0, 1, &viewport);
        vkCmdSetScissor(commands, 0, 1, &info.renderArea);
        vkCmdBindPipeline(commands, pipeline->bindPoint(), pipeline->handle());
        vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_ALL, 0, 4, &rounds);
        vkCmdDraw(commands, 3, 1, 0, 0);
        vkCmdEndRendering(commands);
        spans->mark(commands);
      }
    }));
  }
  const auto ms = spans->milliseconds();
  ASSERT_EQ(ms.size(), 3u);
  EXPECT_GT(ms[1], 5 * ms[0]) << ms[0] << " " << ms[1] << " " << ms[2];
  EXPECT_GT(ms[1], 5 * ms[2]) << ms[0] << " " << ms[1] << " " << ms[2];
}

TEST_F(GpuTimestamps, MoreMarksThanCapacityIsABug) {
  auto stamps = Timestamps::create(*device, 1);
  ASSERT_TRUE(stamps.ok());
  TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
    stamps->begin(commands);
    stamps->mark(commands);
    EXPECT_DEATH(stamps->mark(commands), "mark 2 of 1");
  }));
}

}  // namespace
}  // namespace tyndall::gpu::test
