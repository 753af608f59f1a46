// PNG: what is written comes back byte for byte; truncated files are refused.
#include "base/file.hpp"
#include "image/image_io.hpp"
#include "temporary_folder.hpp"

using namespace tyndall;
using namespace tyndall::image;

class Png : public TemporaryFolder {};

namespace {

ByteImage pattern(std::uint32_t width, std::uint32_t height, std::uint32_t channels) {
  ByteImage image{width, height, channels, {}};
  for (std::uint32_t i = 0; i < width * height * channels; ++i)
    image.values.push_back(static_cast<std::uint8_t>(i * 2654435761u >> 24));
  return image;
}

}  // namespace

TEST_F(Png, comesBackByteForByte) {
  for (const std::uint32_t channels : {3u, 4u}) {
    const ByteImage image = pattern(31, 17, channels);
    ASSERT_TRUE(writePng(folder_ / "a.png", image));
    const auto back = readPng(folder_ / "a.png");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->width, 31u);
    EXPECT_EQ(back->height, 17u);
    EXPECT_EQ(back->channels, channels);
    EXPECT_EQ(back->values, image.values);
  }
  EXPECT_EQ(fileCount(), 1u);
}

TEST_F(Png, refusesWhatCannotBe) {
  EXPECT_FALSE(writePng(folder_ / "a.png", ByteImage{4, 0, 3, {}}));
  EXPECT_FALSE(writePng(folder_ / "missing" / "a.png", pattern(4, 4, 3)));
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(Png, refusesTruncatedFiles) {
  ASSERT_TRUE(writePng(folder_ / "a.png", pattern(64, 64, 4)));
  const auto whole = readFile(folder_ / "a.png");
  ASSERT_TRUE(whole);
  for (std::size_t cut = 1; cut < whole->size(); cut += whole->size() / 16) {
    ASSERT_TRUE(writeFileAtomically(folder_ / "cut.png", {whole->data(), whole->size() - cut}));
    const auto image = readPng(folder_ / "cut.png");
    ASSERT_FALSE(image) << cut;
    EXPECT_NE(image.error().message.find("cut.png"), std::string::npos);
  }
}
