// Graphics pipelines by dynamic rendering: clear, triangles, depth, blending, geometry shaders, depth only.
#include "gpu_test.hpp"

namespace tyndall::gpu::test {
namespace {

constexpr std::uint32_t kSize = 16;

class GpuGraphics : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    if (!device) return;
    auto colorImage =
        device->createImage({.name = "color",
                             .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                             .width = kSize,
                             .height = kSize,
                             .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    auto depthImage =
        device->createImage({.name = "depth",
                             .format = VK_FORMAT_D32_SFLOAT,
                             .width = kSize,
                             .height = kSize,
                             .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    ASSERT_TRUE(colorImage.ok() && depthImage.ok());
    color = colorImage.take();
    depth = depthImage.take();
    quad = compile("vert", R"(
layout(push_constant, scalar) uniform Push { vec4 box; vec4 colour; float z; };
layout(location = 0) out vec4 outColour;
void main() {
  vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
  gl_Position = vec4(mix(box.xy, box.zw, corner), z, 1);
  outColour = colour;
})");
    flat = compile(
        "frag",
        "layout(location = 0) in vec4 colour; layout(location = 0) out vec4 target; void main() { target = colour; }");
    desc = {.name = "quad",
            .vertex = quad,
            .fragment = flat,
            .pushConstantBytes = 36,
            .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
            .colors = {{VK_FORMAT_R32G32B32A32_SFLOAT}},
            .depthFormat = VK_FORMAT_D32_SFLOAT};
  }
  void TearDown() override {
    color = {};
    depth = {};
    GpuTest::TearDown();
  }
  struct Quad {
    float box[4], colour[4], z;
  };

  /// Clears to (0.25, 0.5, 0.75, 1) and depth 0, then draws.
  std::vector<float> draw(const std::vector<std::pair<const Pipeline*, Quad>>& quads) {
    TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
      transition(commands, color, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
      transition(commands, depth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
      VkRenderingAttachmentInfo target{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
      target.imageView = color.view();
      target.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
      target.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
      target.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
      target.clearValue.color = {{0.25f, 0.5f, 0.75f, 1.0f}};
      VkRenderingAttachmentInfo z = target;
      z.imageView = depth.view();
      z.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
      z.clearValue.depthStencil = {0, 0};
      VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
      info.renderArea = {{0, 0}, {kSize, kSize}};
      info.layerCount = 1;
      info.colorAttachmentCount = 1, info.pColorAttachments = &target, info.pDepthAttachment = &z;
      vkCmdBeginRendering(commands, &info);
      const VkViewport viewport{0, 0, kSize, kSize, 0, 1};
      vkCmdSetViewport(commands, 0, 1, &viewport);
      vkCmdSetScissor(commands, 0, 1, &info.renderArea);
      for (const auto& [pipeline, push] : quads) {
        vkCmdBindPipeline(commands, pipeline->bindPoint(), pipeline->handle());
        vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_ALL, 0, sizeof push, &push);
        vkCmdDraw(commands, 4, 1, 0, 0);
      }
      vkCmdEndRendering(commands);
    }));
    auto bytes = device->readback(color, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    EXPECT_TRUE(bytes.ok());
    return valuesOf<float>(*bytes);
  }
  static std::vector<float> at(const std::vector<float>& picture, std::uint32_t x, std::uint32_t y) {
    const auto start = picture.begin() + static_cast<std::ptrdiff_t>((y * kSize + x) * 4);
    return {start, start + 4};
  }
  Image color, depth;
  std::shared_ptr<const Shader> quad, flat;
  GraphicsPipelineDesc desc;
};

using Texel = std::vector<float>;
const Texel kClear{0.25f, 0.5f, 0.75f, 1.0f};

TEST_F(GpuGraphics, ClearsToTheColourGiven) {
  const auto picture = draw({});
  for (std::uint32_t y = 0; y < kSize; ++y)
    for (std::uint32_t x = 0; x < kSize; ++x) ASSERT_EQ(at(picture, x, y), kClear) << x << ", " << y;
}

TEST_F(GpuGraphics, DrawsTheUpperLeftQuarter) {
  auto pipeline = createPipeline(*device, desc);
  ASSERT_TRUE(pipeline.ok()) << pipeline.error().message;
  EXPECT_EQ(pipeline->bindPoint(), VK_PIPELINE_BIND_POINT_GRAPHICS);
  const auto picture = draw({{&*pipeline, {{-1, -1, 0, 0}, {1, 2, 3, 4}, 0}}});
  for (std::uint32_t y = 0; y < kSize; ++y)
    for (std::uint32_t x = 0; x < kSize; ++x)
      ASSERT_EQ(at(picture, x, y), x < kSize / 2 && y < kSize / 2 ? (Texel{1, 2, 3, 4}) : kClear) << x << ", " << y;
}

TEST_F(GpuGraphics, DepthTestKeepsTheNearerAndClampKeepsWhatIsOutside) {
  desc.depthTest = desc.depthWrite = true;
  auto pipeline = createPipeline(*device, desc);
  desc.depthClamp = true;
  auto clamped = createPipeline(*device, desc);
  ASSERT_TRUE(pipeline.ok() && clamped.ok());
  const Quad near{{-1, -1, 1, 1}, {1, 0, 0, 1}, 0.75f}, far{{-1, -1, 1, 1}, {0, 1, 0, 1}, 0.5f};
  EXPECT_EQ(at(draw({{&*pipeline, near}, {&*pipeline, far}}), 3, 3), (Texel{1, 0, 0, 1}));
  EXPECT_EQ(at(draw({{&*pipeline, far}, {&*pipeline, near}}), 3, 3), (Texel{1, 0, 0, 1}));
  auto depths = device->readback(depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
  ASSERT_TRUE(depths.ok());
  EXPECT_EQ(valuesOf<float>(*depths)[0], 0.75f);
  const Quad outside{{-1, -1, 1, 1}, {0, 0, 1, 1}, 1.5f};
  EXPECT_EQ(at(draw({{&*pipeline, outside}}), 3, 3), kClear);
  EXPECT_EQ(at(draw({{&*clamped, outside}}), 3, 3), (Texel{0, 0, 1, 1}));
}

TEST_F(GpuGraphics, BlendsBySourceAlpha) {
  desc.colors[0] = {VK_FORMAT_R32G32B32A32_SFLOAT, true,
                    VK_BLEND_FACTOR_SRC_ALPHA,     VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
                    VK_BLEND_FACTOR_ONE,           VK_BLEND_FACTOR_ZERO};
  auto pipeline = createPipeline(*device, desc);
  ASSERT_TRUE(pipeline.ok()) << pipeline.error().message;
  const auto texel = at(draw({{&*pipeline, {{-1, -1, 1, 1}, {1, 0, 0, 0.25f}, 0}}}), 8, 8);
  const Texel expected{0.25f + 0.75f * 0.25f, 0.75f * 0.5f, 0.75f * 0.75f, 0.25f};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(texel[i], expected[i], 1e-6f);
}

TEST_F(GpuGraphics, CullsByTheFrontFace) {
  desc.cull = VK_CULL_MODE_BACK_BIT;
  auto oneWay = createPipeline(*device, desc);
  desc.frontFace = VK_FRONT_FACE_CLOCKWISE;
  auto otherWay = createPipeline(*device, desc);
  ASSERT_TRUE(oneWay.ok() && otherWay.ok());
  const Quad all{{-1, -1, 1, 1}, {1, 1, 1, 1}, 0};
  const bool one = at(draw({{&*oneWay, all}}), 8, 8) != kClear, other = at(draw({{&*otherWay, all}}), 8, 8) != kClear;
  EXPECT_NE(one, other);
}

TEST_F(GpuGraphics, GeometryShaderMovesTheQuad) {
  desc.geometry = compile("geom", R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
layout(location = 0) in vec4 colour[];
layout(location = 0) out vec4 outColour;
void main() {
  for (int i = 0; i < 3; ++i) {
    gl_Position = gl_in[i].gl_Position + vec4(1, 0, 0, 0);
    outColour = colour[i];
    EmitVertex();
  }
  EndPrimitive();
})");
  auto pipeline = createPipeline(*device, desc);
  ASSERT_TRUE(pipeline.ok()) << pipeline.error().message;
  const auto picture = draw({{&*pipeline, {{-1, -1, 0, 0}, {1, 2, 3, 4}, 0}}});
  EXPECT_EQ(at(picture, 2, 2), kClear);
  EXPECT_EQ(at(picture, kSize - 2, 2), (Texel{1, 2, 3, 4}));
}

TEST_F(GpuGraphics, DepthOnlyPipelineNeedsNoFragmentShader) {
  desc.fragment = nullptr;
  desc.colors.clear();
  desc.depthTest = desc.depthWrite = true;
  auto pipeline = createPipeline(*device, desc);
  ASSERT_TRUE(pipeline.ok()) << pipeline.error().message;
  TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
    transition(commands, depth, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    VkRenderingAttachmentInfo z{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    z.imageView = depth.view();
    z.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
    z.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    z.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea = {{0, 0}, {kSize, kSize}};
    info.layerCount = 1;
    info.pDepthAttachment = &z;
    vkCmdBeginRendering(commands, &info);
    const VkViewport viewport{0, 0, kSize, kSize, 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &info.renderArea);
    vkCmdBindPipeline(commands, pipeline->bindPoint(), pipeline->handle());
    const Quad right{{0, -1, 1, 1}, {}, 0.625f};
    vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_ALL, 0, sizeof right, &right);
    vkCmdDraw(commands, 4, 1, 0, 0);
    vkCmdEndRendering(commands);
  }));
  auto depths = device->readback(depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
  ASSERT_TRUE(depths.ok());
  const auto values = valuesOf<float>(*depths);
  EXPECT_EQ(values[2], 0);
  EXPECT_EQ(values[kSize - 2], 0.625f);
}

}  // namespace
}  // namespace tyndall::gpu::test
