// Shaders edited while the renderer lives.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "stage.hpp"

namespace tyndall::render::test {
namespace {

namespace fs = std::filesystem;

using ReloadTest = FrameTest;

// File systems tell times apart by a tick, so each text gets a time of its own: `hours` from now.
void write(const fs::path& path, const std::string& text, int hours) {
  std::ofstream(path) << text;
  fs::last_write_time(path, fs::file_time_type::clock::now() + std::chrono::hours(hours));
}

TEST_F(ReloadTest, AChangedShaderIsUsedAndABrokenOneIsNot) {
  std::string name = (fs::temp_directory_path() / "tyndall-reload-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  const fs::path folder = name;
  for (const auto& file : fs::directory_iterator(fs::path(TYNDALL_BIN_DIR) / "shaders"))
    fs::copy(file, folder / file.path().filename());
  const fs::path source = folder / "composite.frag.glsl";
  const auto shader = [](const std::string& color) {
    return "#version 460\nlayout(binding = 0) uniform sampler2D colorTarget;\nlayout(location = 0) out vec4 "
           "outPicture;\n"
           "void main() { outPicture = " +
           color + "; }\n";
  };
  write(source, shader("vec4(texelFetch(colorTarget, ivec2(0), 0).rgb, 1.0)"), -1);
  write(folder / "composite.frag.spv.json",
        "{ \"source\": \"" + source.string() + "\", \"stage\": \"frag\", \"includes\": [] }\n", -1);

  Result<std::unique_ptr<Renderer>> renderer = Renderer::create(stage().device(), folder);
  ASSERT_TRUE(renderer.ok());
  Stage::Options options;
  options.width = options.height = 8;
  options.renderer = renderer->get();
  const scene::Scene empty;
  const auto pixel = [&] { return stage().render(empty, lookAt({0, 0, 0}, {0, 0, -1}), {}, options).picture[0]; };
  pixel();
  EXPECT_TRUE((*renderer)->reloadShaders().empty()) << "nothing changed yet";
  write(source, shader("vec4(1, 0, 0, 1)"), 1);
  EXPECT_EQ((*renderer)->reloadShaders().size(), 1u);
  EXPECT_EQ(pixel(), glm::u8vec4(255, 0, 0, 255));
  write(source, shader("vec4(nonsense"), 2);
  EXPECT_EQ((*renderer)->reloadShaders().size(), 1u);
  EXPECT_EQ(pixel(), glm::u8vec4(255, 0, 0, 255)) << "the last good one";
  write(source, shader("vec4(0, 1, 0, 1)"), 3);
  EXPECT_EQ((*renderer)->reloadShaders().size(), 1u);
  EXPECT_EQ(pixel(), glm::u8vec4(0, 255, 0, 255));
  fs::remove_all(folder);
}

TEST_F(ReloadTest, AMissingShaderFolderIsAnError) {
  EXPECT_FALSE(Renderer::create(stage().device(), "no/such/folder").ok());
}

}  // namespace
}  // namespace tyndall::render::test
