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

constexpr VkImageUsageFlags kCopies = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;

TEST_F(GpuTransfer, EveryFormatOddSizesMipsAndLayersComeBack) {
  const VkFormat formats[] = {VK_FORMAT_R8_UNORM, VK_FORMAT_R8G8_UNORM, VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R8G8B8A8_SRGB,
                              VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_FORMAT_B10G11R11_UFLOAT_PACK32, VK_FORMAT_R16_UNORM,
                              VK_FORMAT_R16G16_SFLOAT, VK_FORMAT_R16G16B16A16_UNORM, VK_FORMAT_R16G16B16A16_SFLOAT,
                              VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT,
                              VK_FORMAT_R32G32B32A32_UINT, VK_FORMAT_D32_SFLOAT};
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
  ImageDesc desc{.name = "volume", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .width = 9, .height = 7, .depth = 5, .mips = 2,
                 .type = VK_IMAGE_TYPE_3D, .usage = kCopies};
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
  auto image = device->createImage({.name = "large", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .width = kWidth, .height = kHeight, .usage = kCopies});
  ASSERT_TRUE(image.ok()) << image.error().message;
  const auto texels = noise(std::size_t{kWidth} * kHeight * 16);
  TY_EXPECT_OK(device->upload(*image, texels));
  auto back = device->readback(*image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  ASSERT_TRUE(back.ok());
  EXPECT_TRUE(*back == texels);

  auto volume = device->createImage({.name = "large volume", .format = VK_FORMAT_R32G32B32A32_SFLOAT, .width = 101, .height = 103, .depth = 110,
                                     .type = VK_IMAGE_TYPE_3D, .usage = kCopies});  // 18 MB: whole slices, not all at once
  ASSERT_TRUE(volume.ok()) << volume.error().message;
  const auto voxels = noise(std::size_t{101} * 103 * 110 * 16);
  TY_EXPECT_OK(device->upload(*volume, voxels));
  auto backVolume = device->readback(*volume, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  ASSERT_TRUE(backVolume.ok());
  EXPECT_TRUE(*backVolume == voxels);

  auto buffer = device->createBuffer({.name = "large", .size = texels.size(),
                                      .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
  ASSERT_TRUE(buffer.ok()) << buffer.error().message;
  TY_EXPECT_OK(device->upload(*buffer, texels));
  auto backBuffer = device->readback(*buffer);
  ASSERT_TRUE(backBuffer.ok());
  EXPECT_TRUE(*backBuffer == texels);
}

TEST_F(GpuTransfer, PartOfABufferIsReplaced) {
  for (const bool hostVisible : {false, true}) {
    auto buffer = device->createBuffer({.name = "part", .size = 100,
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
