// Compute pipelines: push descriptors, push constants, specialization.
#include "gpu_test.hpp"

namespace tyndall::gpu::test {
namespace {

class GpuCompute : public GpuTest {};

constexpr const char* kSquare = R"(
layout(constant_id = 7) const uint kOffset = 0;
layout(local_size_x_id = 8) in;
layout(push_constant, scalar) uniform Push { uint count; float scale; };
layout(binding = 0, scalar) readonly buffer In { float values[]; };
layout(binding = 1, scalar) writeonly buffer Out { float squares[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i < count) squares[i] = scale * values[i] * values[i] + float(kOffset);
}
)";

TEST_F(GpuCompute, SquaresNumbers) {
  constexpr std::uint32_t kCount = 1000;
  std::vector<float> values(kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) values[i] = static_cast<float>(i) * 0.25f - 100;
  constexpr VkBufferUsageFlags kUsage =
      VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
  auto in = device->createBuffer({.name = "in", .size = kCount * 4, .usage = kUsage});
  auto out = device->createBuffer({.name = "out", .size = kCount * 4, .usage = kUsage});
  TY_EXPECT_OK(in);
  TY_EXPECT_OK(out);
  TY_EXPECT_OK(device->upload(*in, bytesOf(values)));
  ComputePipelineDesc desc{.name = "square",
                           .shader = compile("comp", kSquare),
                           .bindings = {{0}, {1}},
                           .pushConstantBytes = 8,
                           .specialization = {{7, 5}, {8, 64}}};
  auto pipeline = createPipeline(*device, desc);
  TY_EXPECT_OK(pipeline);
  struct {
    std::uint32_t count;
    float scale;
  } push{kCount, 2.0f};
  TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
    vkCmdBindPipeline(commands, pipeline->bindPoint(), pipeline->handle());
    Descriptors(commands, *pipeline).storageBuffer(0, in->handle()).storageBuffer(1, out->handle()).push();
    vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_ALL, 0, sizeof push, &push);
    vkCmdDispatch(commands, (kCount + 63) / 64, 1, 1);
  }));
  auto bytes = device->readback(*out);
  TY_EXPECT_OK(bytes);
  const auto squares = valuesOf<float>(*bytes);
  ASSERT_EQ(squares.size(), kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) ASSERT_EQ(squares[i], 2 * values[i] * values[i] + 5) << i;
}

TEST_F(GpuCompute, WritesAnImageAndSamplesIt) {
  const auto write = compile("comp", R"(
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) writeonly uniform image2D target;
layout(binding = 1, scalar) uniform U { float step; };
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(p, imageSize(target)))) imageStore(target, p, vec4(float(p.x) + step * float(p.y)));
}
)");
  const auto read = compile("comp", R"(
layout(local_size_x = 1) in;
layout(binding = 0) uniform sampler2D source;
layout(binding = 1, scalar) writeonly buffer Out { float sum[]; };
void main() {
  float s = 0;
  for (int y = 0; y < textureSize(source, 0).y; ++y)
    for (int x = 0; x < textureSize(source, 0).x; ++x) s += texelFetch(source, ivec2(x, y), 0).r;
  sum[0] = s;
  sum[1] = textureLod(source, vec2(1.0 / 13.0, 0.5 / 5.0), 0).r;  // between the first two texels of 13x5
}
)");
  auto image = device->createImage({.name = "target",
                                    .format = VK_FORMAT_R32_SFLOAT,
                                    .width = 13,
                                    .height = 5,
                                    .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
  auto uniform = device->createBuffer(
      {.name = "step", .size = 4, .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, .hostVisible = true});
  auto sum = device->createBuffer(
      {.name = "sum", .size = 8, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, .hostVisible = true});
  TY_EXPECT_OK(image);
  TY_EXPECT_OK(uniform);
  TY_EXPECT_OK(sum);
  TY_EXPECT_OK(device->upload(*uniform, bytesOf(std::vector<float>{100.0f})));
  auto writer = createPipeline(*device, ComputePipelineDesc{.name = "write",
                                                            .shader = write,
                                                            .bindings = {{0, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
                                                                         {1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER}}});
  auto reader = createPipeline(
      *device, ComputePipelineDesc{
                   .name = "read", .shader = read, .bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, {1}}});
  TY_EXPECT_OK(writer);
  TY_EXPECT_OK(reader);
  VkSamplerCreateInfo linear{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  linear.magFilter = linear.minFilter = VK_FILTER_LINEAR;
  const VkSampler sampler = device->sampler(linear);
  EXPECT_EQ(device->sampler(linear), sampler);
  linear.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  EXPECT_NE(device->sampler(linear), sampler);
  TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
    transition(commands, *image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
    vkCmdBindPipeline(commands, writer->bindPoint(), writer->handle());
    Descriptors(commands, *writer).storageImage(0, image->view()).uniformBuffer(1, uniform->handle(), 0, 4).push();
    vkCmdDispatch(commands, 2, 1, 1);
    transition(commands, *image, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    vkCmdBindPipeline(commands, reader->bindPoint(), reader->handle());
    Descriptors(commands, *reader).sampled(0, image->view(), sampler).storageBuffer(1, sum->handle()).push();
    vkCmdDispatch(commands, 1, 1, 1);
  }));
  auto bytes = device->readback(*sum);
  TY_EXPECT_OK(bytes);
  const auto values = valuesOf<float>(*bytes);
  EXPECT_EQ(values[0], 5 * (12 * 13 / 2) + 100 * 13 * (4 * 5 / 2));
  EXPECT_NEAR(values[1], 0.5f, 1e-5f);
}

TEST_F(GpuCompute, MoreThanTheDeviceTakesIsRefused) {
  const auto shader = compile("comp", "layout(local_size_x = 1) in; void main() {}");
  ComputePipelineDesc desc{.name = "greedy", .shader = shader, .pushConstantBytes = 1u << 20};
  auto pushes = createPipeline(*device, desc);
  ASSERT_FALSE(pushes.ok());
  EXPECT_NE(pushes.error().message.find("greedy"), std::string::npos);
  desc.pushConstantBytes = 0;
  for (std::uint32_t i = 0; i <= device->info().maxPushDescriptors; ++i) desc.bindings.push_back({i});
  EXPECT_FALSE(createPipeline(*device, desc).ok());
}

}  // namespace
}  // namespace tyndall::gpu::test
