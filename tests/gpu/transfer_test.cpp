// Uploads and readback: formats, odd sizes, mips, layers, slices, and data larger than the staging buffer.
#include <random>

#include "gpu_test.hpp"

namespace tyndall::gpu::test {
namespace {

class GpuTransfer : public GpuTest {
 protected:
  std::vector<std::byte> noise(std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (auto& byte : bytes) byte = static_cast<std::byte>(random_() & 0x3f);  // no NaN in any format, no -1 in snorm
    return bytes;
  }
  std::mt19937 random_{7};
};

constexpr VkImageUsageFlags kCopies =
    VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;

TEST_F(GpuTransfer, EveryFormatOddSizesMipsAndLayersComeBack) {
  const VkFormat formats[] = {VK_FORMAT_R8_UNORM,
                              VK_FORMAT_R8G8_UNORM,
                              VK_FORMAT_R8G8B8A8_UNORM,
                              VK_FORMAT_R8G8B8A8_SRGB,
                              VK_FORMAT_A2B10G10R10_UNORM_PACK32,
                              VK_FORMAT_B10G11R11_UFLOAT_PACK32,
                              VK_FORMAT_R16_UNORM,
                              VK_FORMAT_R16G16_SFLOAT,
                              VK_FORMAT_R16G16B16A16_UNORM,
                              VK_FORMAT_R16G16B16A16_SFLOAT,
                              VK_FORMAT_R32_SFLOAT,
                              VK_FORMAT_R32G32_SFLOAT,
                              VK_FORMAT_R32G32B32A32_SFLOAT,
                              VK_FORMAT_R32G32B32A32_UINT,
                              VK_FORMAT_D32_SFLOAT};
  for (const VkFormat format : formats) {
    SCOPED_TRACE("format " + std::to_string(format));
    ImageDesc desc{.name = "odd", .format = format, .width = 37, .height = 5, .layers = 3, .mips = 6, .usage = kCopies};
    auto image = device->createImage(desc);
    ASSERT_TRUE(image.ok()) << image.error().message;
    std::vector<std::vector<std::byte>> sent;
    for (std::uint32_t layer = 0; layer < desc.layers; ++layer)
      for (std::uint32_t mip = 0; mip < desc.mips; ++mip) {
        sent.push_back(noise(std::size_t{std::max(1u, 37u >> mip)} * std::max(1u, 5u >> mip) * texelBytes(format)));
        TY_EXPECT_OK(device->upload(*image, sent.back(), mip, layer));
      }
    for (int pass = 0; pass < 2; ++pass) {  // twice: readback returns the image to its layout
      std::size_t next = 0;
      for (std::uint32_t layer = 0; layer < desc.layers; ++layer)
        for (std::uint32_t mip = 0; mip < desc.mips; ++mip) {
          auto got = device->readback(*image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, mip, layer);
          ASSERT_TRUE(got.ok()) << got.error().message;
          ASSERT_EQ(*got, sent[next++]) << "mip " << mip << " layer " << layer;
        }
    }
  }
}

TEST_F(GpuTransfer, SlicesOfA3DImageComeBack) {
  ImageDesc desc{.name = "volume",
                 .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                 .width = 9,
                 .height = 7,
                 .depth = 5,
                 .mips = 2,
                 .type = VK_IMAGE_TYPE_3D,
                 .usage = kCopies};
  auto image = device->createImage(desc);
  ASSERT_TRUE(image.ok()) << image.error().message;
  const auto whole = noise(9 * 7 * 5 * 8), half = noise(4 * 3 * 2 * 8);
  TY_EXPECT_OK(device->upload(*image, whole));
  TY_EXPECT_OK(device->upload(*image, half, 1));
  EXPECT_EQ(*device->readback(*image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL), whole);
  EXPECT_EQ(*device->readback(*image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, 1), half);
}

TEST_F(GpuTransfer, MoreThanTheStagingBufferGoesInPieces) {
  constexpr std::uint32_t kWidth = 1531, kHeight = 1511;  // 37 MB, and no power of two
  auto image = device->createImage(
      {.name = "large", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .width = kWidth, .height = kHeight, .usage = kCopies});
  ASSERT_TRUE(image.ok()) << image.error().message;
  const auto texels = noise(std::size_t{kWidth} * kHeight * 16);
  TY_EXPECT_OK(device->upload(*image, texels));
  auto back = device->readback(*image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  ASSERT_TRUE(back.ok());
  EXPECT_TRUE(*back == texels);

  auto volume = device->createImage({.name = "large volume",
                                     .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                     .width = 101,
                                     .height = 103,
                                     .depth = 110,
                                     .type = VK_IMAGE_TYPE_3D,
                                     .usage = kCopies});  // 18 MB: whole slices, not all at once
  ASSERT_TRUE(volume.ok()) << volume.error().message;
  const auto voxels = noise(std::size_t{101} * 103 * 110 * 16);
  TY_EXPECT_OK(device->upload(*volume, voxels));
  auto backVolume = device->readback(*volume, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  ASSERT_TRUE(backVolume.ok());
  EXPECT_TRUE(*backVolume == voxels);

  auto buffer = device->createBuffer({.name = "large",
                                      .size = texels.size(),
                                      .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
  ASSERT_TRUE(buffer.ok()) << buffer.error().message;
  TY_EXPECT_OK(device->upload(*buffer, texels));
  auto backBuffer = device->readback(*buffer);
  ASSERT_TRUE(backBuffer.ok());
  EXPECT_TRUE(*backBuffer == texels);
}

TEST_F(GpuTransfer, AViewShowsTheMipAndLayerAskedFor) {
  // A value of its own in each of 3 layers x 2 mips, read through views of every kind.
  auto image = device->createImage({.name = "stack",
                                    .format = VK_FORMAT_R32_SFLOAT,
                                    .width = 2,
                                    .height = 2,
                                    .layers = 3,
                                    .mips = 2,
                                    .usage = kCopies});
  auto out = device->createBuffer(
      {.name = "out", .size = 4, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, .hostVisible = true});
  ASSERT_TRUE(image.ok() && out.ok());
  for (std::uint32_t layer = 0; layer < 3; ++layer)
    for (std::uint32_t mip = 0; mip < 2; ++mip)
      TY_EXPECT_OK(device->upload(
          *image, bytesOf(std::vector<float>(mip ? 1 : 4, static_cast<float>(layer * 10 + mip))), mip, layer));
  const auto read = [&](const ViewDesc& view, const std::string& type, const std::string& at) {
    const auto shader = compile(
        "comp", "layout(local_size_x = 1) in; layout(binding = 0) uniform " + type +
                    " s; layout(binding = 1) buffer B { float v; }; void main() { v = texelFetch(s, " + at + ").r; }");
    auto pipeline =
        createPipeline(*device, ComputePipelineDesc{.name = "read",
                                                    .shader = shader,
                                                    .bindings = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, {1}}});
    EXPECT_TRUE(pipeline.ok());
    const VkSampler sampler = device->sampler({VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO});
    TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, pipeline->bindPoint(), pipeline->handle());
      Descriptors(commands, *pipeline).sampled(0, image->view(view), sampler).storageBuffer(1, out->handle()).push();
      vkCmdDispatch(commands, 1, 1, 1);
    }));
    return valuesOf<float>(*device->readback(*out)).at(0);
  };
  EXPECT_EQ(read({}, "sampler2DArray", "ivec3(1, 0, 2), 0"), 20);
  EXPECT_EQ(read({}, "sampler2DArray", "ivec3(0, 0, 1), 1"), 11);
  EXPECT_EQ(read({.baseMip = 1, .baseLayer = 1, .layerCount = 1}, "sampler2D", "ivec2(0), 0"), 11);
  EXPECT_EQ(read({.baseLayer = 2, .layerCount = 1, .array = true}, "sampler2DArray", "ivec3(0), 1"), 21);
  EXPECT_EQ(read({.baseLayer = 1}, "sampler2DArray", "ivec3(0, 0, 1), 0"), 20);
  EXPECT_EQ(image->view({}), image->view({.mipCount = 2, .layerCount = 3, .array = true}))
      << "the same part, asked for twice";
  EXPECT_DEATH(image->view({.baseLayer = 3}), "view outside of image 'stack'");
}

TEST_F(GpuTransfer, PartOfABufferIsReplaced) {
  for (const bool hostVisible : {false, true}) {
    auto buffer = device->createBuffer({.name = "part",
                                        .size = 100,
                                        .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                        .hostVisible = hostVisible});
    ASSERT_TRUE(buffer.ok()) << buffer.error().message;
    EXPECT_EQ(buffer->mapped() != nullptr, hostVisible);
    auto expected = noise(100);
    TY_EXPECT_OK(device->upload(*buffer, expected));
    const auto part = noise(12);
    TY_EXPECT_OK(device->upload(*buffer, part, 48));
    std::copy(part.begin(), part.end(), expected.begin() + 48);
    EXPECT_EQ(*device->readback(*buffer), expected);
  }
}

TEST_F(GpuTransfer, AnUploadReplacesWhatEarlierFramesRead) {
  // Two frames copy a buffer before and after an upload: the first must see the old bytes.
  constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  constexpr std::size_t kSize = 1 << 20;
  auto source = device->createBuffer({.name = "source", .size = kSize, .usage = kUsage});
  auto before = device->createBuffer({.name = "before", .size = kSize, .usage = kUsage});
  auto after = device->createBuffer({.name = "after", .size = kSize, .usage = kUsage});
  ASSERT_TRUE(source.ok() && before.ok() && after.ok());
  const auto old = noise(kSize), fresh = noise(kSize);
  TY_EXPECT_OK(device->upload(*source, old));
  const auto frame = [&](Buffer& target) {
    auto commands = device->beginFrame();
    ASSERT_TRUE(commands.ok());
    const VkBufferCopy copy{0, 0, kSize};
    vkCmdCopyBuffer(*commands, source->handle(), target.handle(), 1, &copy);
    TY_EXPECT_OK(device->endFrame());
  };
  frame(*before);
  TY_EXPECT_OK(device->upload(*source, fresh));
  frame(*after);
  EXPECT_TRUE(*device->readback(*before) == old);
  EXPECT_TRUE(*device->readback(*after) == fresh);
}

}  // namespace
}  // namespace tyndall::gpu::test
