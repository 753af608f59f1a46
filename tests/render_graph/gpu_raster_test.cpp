// Raster passes between compute passes: clears, loads, blending, read-only depth, layers, mips, imports.
#include "gpu_helpers.hpp"

namespace tyndall::render::test {
namespace {

constexpr std::uint32_t kWidth = 48, kHeight = 32;

// A triangle over the pixels left of `right` (in clip space), at one depth.
constexpr const char* kVertex = R"(
layout(push_constant, scalar) uniform Push { float right; float depth; float value; };
void main() {
  vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
  gl_Position = vec4(mix(vec2(-1), vec2(right, 1), corner), depth, 1);
})";
constexpr const char* kConstant = R"(
layout(push_constant, scalar) uniform Push { float right; float depth; float value; };
layout(location = 0) out vec4 color;
void main() { color = vec4(value); })";
constexpr const char* kFetch = R"(
layout(push_constant, scalar) uniform Push { float right; float depth; float value; };
layout(binding = 0) uniform sampler2D source;
layout(location = 0) out vec4 color;
void main() { color = vec4(2 * texelFetch(source, ivec2(gl_FragCoord.xy), 0).r + value); })";
constexpr const char* kRamp = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D target;
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  imageStore(target, p, vec4(float(p.x + 100 * p.y)));
})";
constexpr const char* kCombine = R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D color;
layout(binding = 1) uniform sampler2D depth;
layout(binding = 2, scalar) writeonly buffer Out { float values[]; };
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  values[p.y * 48 + p.x] = texelFetch(color, p, 0).r + 10000 * texelFetch(depth, p, 0).r;
})";

struct Push {
  float right = 1, depth = 0.5f, value = 0;
};

class GraphRaster : public GraphGpuTest {
 protected:
  gpu::Pipeline graphics(const char* fragment, bool blend, bool depthTest, bool depthWrite) {
    gpu::GraphicsPipelineDesc desc{.name = "test",
                                   .vertex = compile("vert", kVertex),
                                   .fragment = compile("frag", fragment),
                                   .pushConstantBytes = sizeof(Push),
                                   .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP};
    if (fragment == kFetch) desc.bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
    desc.colors = {{.format = VK_FORMAT_R32_SFLOAT,
                    .blend = blend,
                    .destinationFactor = blend ? VK_BLEND_FACTOR_ONE : VK_BLEND_FACTOR_ZERO,
                    .destinationAlphaFactor = blend ? VK_BLEND_FACTOR_ONE : VK_BLEND_FACTOR_ZERO}};
    if (depthTest || depthWrite) desc.depthFormat = VK_FORMAT_D32_SFLOAT;
    desc.depthTest = depthTest;
    desc.depthWrite = depthWrite;
    auto made = gpu::createPipeline(*device, desc);
    EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().message);
    return made.take();
  }

  static void draw(PassContext& c, const gpu::Pipeline& pipeline, const Push& values) {
    bind(c, pipeline);
    push(c, pipeline, values);
    vkCmdDraw(c.commands(), 4, 1, 0, 0);
  }

  static gpu::ImageDesc desc(const char* name, VkFormat format, std::uint32_t layers = 1, std::uint32_t mips = 1) {
    return {.name = name, .format = format, .width = kWidth, .height = kHeight, .layers = layers, .mips = mips};
  }

  VkSampler nearest() {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    return device->sampler(info);
  }
};

TEST_F(GraphRaster, ComputeRasterBlendReadOnlyDepthCompute) {
  const gpu::Pipeline ramp = compute(kRamp, {{0, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}});
  const gpu::Pipeline combine = compute(
      kCombine, {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, {2}});
  const gpu::Pipeline fill = graphics(kFetch, false, true, true), add = graphics(kConstant, true, true, false);
  const VkSampler sampler = nearest();
  const gpu::Buffer result = hostBuffer(kWidth * kHeight * 4);
  Graph graph(*device, *memory);
  const ImageRef source = graph.image(desc("source", VK_FORMAT_R32_SFLOAT)),
                 color = graph.image(desc("color", VK_FORMAT_R32_SFLOAT)),
                 depth = graph.image(desc("depth", VK_FORMAT_D32_SFLOAT));
  const BufferRef out = graph.import(result);
  graph.pass("ramp").use(source, Use::kStorageWriteCompute).run([&](PassContext& c) {
    bind(c, ramp);
    gpu::Descriptors(c.commands(), ramp).storageImage(0, c.view(source)).push();
    vkCmdDispatch(c.commands(), kWidth / 8, kHeight / 8, 1);
  });
  // Left three quarters: colour 2·ramp + 1 at depth 0.5; the rest stays cleared to 3 at depth 0.25.
  graph.pass("fill")
      .use(source, Use::kSampledGraphics)
      .use(color, Use::kColorWrite)
      .use(depth, Use::kDepthWrite)
      .run([&](PassContext& c) {
        const PassContext::DepthAttachment target{.image = depth, .clear = true, .value = 0.25f};
        c.beginRendering({{.image = color, .clear = true, .value = {{3, 3, 3, 3}}}}, &target);
        bind(c, fill);
        gpu::Descriptors(c.commands(), fill).sampled(0, c.view(source), sampler).push();
        draw(c, fill, {.right = 0.5f, .depth = 0.5f, .value = 1});
        c.endRendering();
      });
  // Adds 7 everywhere at depth 0.375: reversed depth keeps it where 0.375 >= stored, the right quarter.
  graph.pass("add").use(color, Use::kColorReadWrite).use(depth, Use::kDepthRead).run([&](PassContext& c) {
    const PassContext::DepthAttachment target{.image = depth, .readOnly = true};
    c.beginRendering({{.image = color}}, &target);
    draw(c, add, {.right = 1, .depth = 0.375f, .value = 7});
    c.endRendering();
  });
  graph.pass("combine")
      .use(color, Use::kSampledCompute)
      .use(depth, Use::kSampledCompute)
      .use(out, Use::kStorageWriteCompute)
      .run([&](PassContext& c) {
        bind(c, combine);
        gpu::Descriptors(c.commands(), combine)
            .sampled(0, c.view(color), sampler)
            .sampled(1, c.view(depth), sampler)
            .storageBuffer(2, c.buffer(out))
            .push();
        vkCmdDispatch(c.commands(), kWidth / 8, kHeight / 8, 1);
      });
  compileAndRun(graph);
  const auto values = hostValues<float>(result);
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const auto ramped = static_cast<float>(x + 100 * y);
      const float wanted = x < kWidth * 3 / 4 ? 2 * ramped + 1 + 5000 : 3 + 7 + 2500;
      ASSERT_EQ(values[y * kWidth + x], wanted) << x << ", " << y;
    }
}

// Layers written by passes of their own: a later pass must not lose what an earlier one wrote beside it.
TEST_F(GraphRaster, LayersAndMipsOfOneImageByDifferentPasses) {
  const gpu::Buffer results[2] = {hostBuffer(kWidth * kHeight * 4), hostBuffer(kWidth * kHeight * 4)};
  const gpu::Pipeline paint = graphics(kConstant, false, false, false);
  Graph graph(*device, *memory);
  const ImageRef image = graph.image(desc("layered", VK_FORMAT_R32_SFLOAT, 2, 2));
  for (std::uint32_t layer = 0; layer < 2; ++layer)
    graph.pass("layer").use(image, Use::kColorWrite).run([&, layer](PassContext& c) {
      for (std::uint32_t mip = 0; mip < 2; ++mip) {  // the smaller mip has its own viewport
        const auto cleared = static_cast<float>(10 + layer);
        c.beginRendering({{.image = image,
                           .clear = true,
                           .value = {{cleared, 0, 0, 0}},
                           .view = {.baseMip = mip, .mipCount = 1, .baseLayer = layer, .layerCount = 1}}});
        draw(c, paint, {.right = 0, .value = static_cast<float>(20 + layer)});
        c.endRendering();
      }
    });
  for (std::uint32_t layer = 0; layer < 2; ++layer)
    copyOut(graph, image, graph.import(results[layer]), VK_IMAGE_ASPECT_COLOR_BIT, layer);
  compileAndRun(graph);
  for (std::uint32_t layer = 0; layer < 2; ++layer) {
    const auto values = hostValues<float>(results[layer]);
    EXPECT_EQ(values[kWidth / 2 - 1], 20 + static_cast<float>(layer));
    EXPECT_EQ(values[kWidth / 2], 10 + static_cast<float>(layer));
  }
}

// Two renderings of one pass over the same texels: the second loads what the first left.
TEST_F(GraphRaster, TwoRenderingsInOnePassAdd) {
  const gpu::Buffer result = hostBuffer(kWidth * kHeight * 4);
  const gpu::Pipeline add = graphics(kConstant, true, false, false);
  Graph graph(*device, *memory);
  const ImageRef image = graph.image(desc("sum", VK_FORMAT_R32_SFLOAT));
  graph.pass("twice").use(image, Use::kColorWrite).run([&](PassContext& c) {
    for (const bool first : {true, false}) {
      c.beginRendering({{.image = image, .clear = first, .value = {{1, 1, 1, 1}}}});
      draw(c, add, {.value = 2});
      c.endRendering();
    }
  });
  copyOut(graph, image, graph.import(result), VK_IMAGE_ASPECT_COLOR_BIT);
  compileAndRun(graph);
  for (const float value : hostValues<float>(result)) ASSERT_EQ(value, 5);
}

TEST_F(GraphRaster, ImportsKeepContentsAndReachTheirLayout) {
  gpu::ImageDesc wanted = desc("history", VK_FORMAT_R32_SFLOAT);
  wanted.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  auto history = device->createImage(wanted);
  TY_EXPECT_OK(history);
  const gpu::Pipeline add = graphics(kConstant, true, false, false);
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
  for (int frame = 0; frame < 5; ++frame) {
    Graph graph(*device, *memory);
    const ImageRef image = graph.import(*history, layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    EXPECT_EQ(graph.import(*history, layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL), image);
    graph.pass("add").use(image, frame == 0 ? Use::kColorWrite : Use::kColorReadWrite).run([&](PassContext& c) {
      c.beginRendering({{.image = image, .clear = frame == 0}});
      draw(c, add, {.value = 1});
      c.endRendering();
    });
    compileAndRun(graph);
    layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  }
  auto bytes = device->readback(*history, layout);
  TY_EXPECT_OK(bytes);
  for (const float value : valuesOf<float>(*bytes)) ASSERT_EQ(value, 5);
}

TEST_F(GraphRaster, AForeignImageIsDrawnToByItsOneView) {
  gpu::ImageDesc wanted = desc("foreign", VK_FORMAT_R32_SFLOAT);
  wanted.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  auto foreign = device->createImage(wanted);
  TY_EXPECT_OK(foreign);
  Graph graph(*device, *memory);
  const ImageRef image =
      graph.importRaw(foreign->handle(), foreign->view(), wanted, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  graph.pass("clear").use(image, Use::kColorWrite).run([&](PassContext& c) {
    c.beginRendering({{.image = image, .clear = true, .value = {{4, 0, 0, 0}}}});
    c.endRendering();
  });
  compileAndRun(graph);
  auto bytes = device->readback(*foreign, VK_IMAGE_LAYOUT_GENERAL);
  TY_EXPECT_OK(bytes);
  for (const float value : valuesOf<float>(*bytes)) ASSERT_EQ(value, 4);
}

}  // namespace
}  // namespace tyndall::render::test
