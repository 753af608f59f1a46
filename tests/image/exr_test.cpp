// EXR: what is written comes back bit for bit, the file says what the contract promises, bad files are refused.
#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "base/file.hpp"
#include "image/image_io.hpp"
#include "temporary_folder.hpp"

using namespace tyndall;
using namespace tyndall::image;

class Exr : public TemporaryFolder {};

namespace {

FloatImage noise(std::uint32_t width, std::uint32_t height, std::uint32_t channels) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> exponent(-30, 30);
  FloatImage image{width, height, channels, {}};
  image.values.resize(std::size_t{width} * height * channels);
  for (float& value : image.values) value = std::exp2(exponent(random)) * (random() % 2 ? 1.0f : -1.0f);
  return image;
}

}  // namespace

TEST_F(Exr, comesBackBitForBit) {
  for (const std::uint32_t channels : {1u, 3u, 4u}) {
    FloatImage image = noise(37, 19, channels);
    image.values[0] = std::numeric_limits<float>::infinity();
    const auto path = folder_ / "a.exr";
    ASSERT_TRUE(writeExr(path, image));
    const auto back = readExr(path);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->width, 37u);
    EXPECT_EQ(back->height, 19u);
    EXPECT_EQ(back->channels, channels);
    EXPECT_EQ(back->values, image.values);
  }
  EXPECT_EQ(fileCount(), 1u);
}

// Read by OpenEXR itself, so that a mistake made the same way in writing and reading shows.
TEST_F(Exr, hasRowZeroOnTopAndTheChannelsOfTheContract) {
  FloatImage image{2, 3, 4, {}};
  for (int i = 0; i < 24; ++i) image.values.push_back(static_cast<float>(i));
  const auto path = folder_ / "a.exr";
  ASSERT_TRUE(writeExr(path, image));
  Imf::InputFile file(path.c_str());
  EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({0, 0}, {1, 2}));
  EXPECT_EQ(file.header().displayWindow(), Imath::Box2i({0, 0}, {1, 2}));
  EXPECT_EQ(file.header().channels()["B"].type, Imf::FLOAT);
  float blue[6] = {};
  Imf::FrameBuffer buffer;
  buffer.insert("B", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(blue), sizeof(float), 2 * sizeof(float)));
  file.setFrameBuffer(buffer);
  file.readPixels(0, 2);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(blue[i], static_cast<float>(4 * i + 2));

  ASSERT_TRUE(writeExr(path, noise(4, 4, 1)));
  Imf::InputFile depth(path.c_str());
  ASSERT_NE(depth.header().channels().findChannel("Z"), nullptr);
  EXPECT_EQ(depth.header().channels()["Z"].type, Imf::FLOAT);
}

TEST_F(Exr, refusesWhatCannotBe) {
  EXPECT_FALSE(writeExr(folder_ / "a.exr", FloatImage{0, 4, 4, {}}));
  EXPECT_FALSE(writeExr(folder_ / "missing" / "a.exr", noise(4, 4, 4)));
  EXPECT_EQ(fileCount(), 0u);
  const auto missing = readExr(folder_ / "none.exr");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("none.exr"), std::string::npos);
}

TEST_F(Exr, refusesTruncatedFiles) {
  const auto path = folder_ / "a.exr";
  ASSERT_TRUE(writeExr(path, noise(64, 64, 4)));
  const auto whole = readFile(path);
  ASSERT_TRUE(whole);
  for (std::size_t eighths = 0; eighths < 8; ++eighths) {
    const std::span<const std::byte> part(whole->data(), whole->size() * eighths / 8);
    const auto cut = folder_ / "cut.exr";
    ASSERT_TRUE(writeFileAtomically(cut, part));
    const auto image = readExr(cut);
    ASSERT_FALSE(image) << eighths;
    EXPECT_NE(image.error().message.find("cut.exr"), std::string::npos);
    EXPECT_EQ(image.error().message.find('\n'), std::string::npos) << image.error().message;
  }
}
