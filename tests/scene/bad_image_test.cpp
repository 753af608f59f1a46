// Broken and hostile pictures: a level that shows one is shown without it, and a line names it.
#include <filesystem>

#include "gltf_file.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::scene {
namespace {

/// A level that shows `picture`.
struct Level : GltfFile {
  Level() {
    triangle();
    json["images"] = {{{"uri", "picture"}}};
    json["textures"] = {{{"source", 0}}};
    json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
  }
  Result<Import> show(const std::string& picture) {
    folder.write("picture", picture);
    return load();
  }
  /// What is said of a level that has to be shown without this picture.
  std::string toldOf(const std::string& picture) {
    const auto loaded = show(picture);
    EXPECT_TRUE(loaded.ok());
    if (loaded.ok()) {
      EXPECT_FALSE(loaded->scene.materials[0].normalTexture.used());
    }
    return told(loaded, folder / "level.gltf");
  }
};

std::string png(std::uint32_t width, std::uint32_t height) {
  Scene s;
  s.images = {{"", width, height, std::vector<std::uint8_t>(4ull * width * height)}};
  for (std::size_t i = 0; i < s.images[0].rgba.size(); ++i) s.images[0].rgba[i] = static_cast<std::uint8_t>(i * 37);
  TemporaryFolder folder;
  EXPECT_TRUE(writeGlb(s, folder / "a.glb").ok());
  std::ifstream in(folder / "a.glb", std::ios::binary);
  const std::string glb{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = glb.find("\x89PNG");
  return glb.substr(begin, glb.find(std::string("IEND\xae\x42\x60\x82")) + 8 - begin);
}

TEST(BadImages, GoodOneIsShown) {
  Level level;
  const auto loaded = level.show(png(5, 3));
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  const Image& image = loaded->scene.images[0];
  EXPECT_EQ(image.width, 5u);
  EXPECT_EQ(image.height, 3u);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) ASSERT_EQ(image.rgba[i], static_cast<std::uint8_t>(i * 37));
}

TEST(BadImages, EveryTruncationIsTold) {
  Level level;
  const std::string good = png(5, 3);
  for (std::size_t size = 0; size < good.size(); ++size) {
    const std::string text = level.toldOf(good.substr(0, size));
    EXPECT_NE(text.find("images[0]"), std::string::npos) << text;
  }
}

TEST(BadImages, EveryFlippedByteIsNoticedOrHarmless) {
  Level level;
  const std::string good = png(5, 3);
  int refused = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    const auto loaded = level.show(bad);
    ASSERT_TRUE(loaded.ok());
    EXPECT_TRUE(checkScene(loaded->scene).ok());
    if (!loaded->scene.materials[0].normalTexture.used()) ++refused;
  }
  EXPECT_EQ(refused, static_cast<int>(good.size()));  // every byte here is under a checksum or a magic number
}

TEST(BadImages, HugeOnesCostNothing) {
  std::string bad = png(5, 3);
  // IHDR says 65536 x 65536; the checksum over it no longer fits, so it is refused for either reason.
  bad.replace(16, 8, std::string("\0\1\0\0\0\1\0\0", 8));
  Level level;
  EXPECT_NE(level.toldOf(bad).find("images[0]"), std::string::npos);
}

TEST(BadImages, OtherFormats) {
  Level level;
  EXPECT_NE(level.toldOf("GIF89a").find("neither PNG nor JPEG"), std::string::npos);
  EXPECT_NE(level.toldOf("RIFF????WEBPVP8 ").find("WebP"), std::string::npos);
  EXPECT_NE(level.toldOf(std::string("\xff\xd8\xff\xe0\0\x10JFIF", 10)).find("JPEG"), std::string::npos);
  std::filesystem::remove(level.folder / "picture");
  EXPECT_NE(told(level.load(), level.folder / "level.gltf").find("\"picture\": cannot be opened"), std::string::npos);
}

TEST(BadImages, UnshownOnesDoNotMatter) {
  Level level;
  level.json["materials"] = {nlohmann::json::object()};
  EXPECT_TRUE(level.show("rubbish").ok());
}

TEST(BadImages, SharedCollectionNeverCrashes) {
  const std::filesystem::path folder = std::filesystem::path(TYNDALL_SHARED_DIR) / "bad";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  int shown = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension();
    if (extension != ".png" && extension != ".jpg" && extension != ".webp") continue;
    std::ifstream in(entry.path(), std::ios::binary);
    Level level;
    const auto loaded = level.show({std::istreambuf_iterator<char>(in), {}});
    const std::string lines = told(loaded, level.folder / "level.gltf");
    ASSERT_TRUE(loaded.ok()) << lines;
    ++(loaded->scene.materials[0].normalTexture.used() ? shown : refused);
    EXPECT_EQ(loaded->scene.materials[0].normalTexture.used(), lines.empty()) << entry.path() << lines;
  }
  std::printf("%d pictures shown, %d left out\n", shown, refused);
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace tyndall::scene
