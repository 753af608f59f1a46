// A plugin's shader that is edited while the program runs.
#include <fstream>

#include <gmock/gmock.h>

#include "base/file.hpp"
#include "frame_fixture.hpp"

namespace tyndall::host {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Reload : FrameFixture {
  test::TemporaryFolder folder_;
  fs::path source_ = folder_.path() / "accumulate.comp.glsl";

  void SetUp() override {
    FrameFixture::SetUp();
    const fs::path from = TYNDALL_TEST_PLUGINS;
    fs::copy_file(from / "passes.so", folder_.path() / "passes.so");
    fs::copy(from / "passes", folder_.path() / "passes");
    fs::copy_file(fs::path(TYNDALL_SOURCE_DIR) / "tests/host/shaders/accumulate.comp.glsl", source_);
    ASSERT_TRUE(writeTextAtomically(folder_.path() / "passes/accumulate.comp.spv.json",
                                    R"({"source": ")" + source_.string() + R"(", "stage": "comp", "includes": []})"));
    load(folder_.path() / "passes.so");
    addLight(scene::LightKind::kDirectional, glm::vec3(1), 1, 0);
    ASSERT_TRUE(table_.setAssignment("passes.variant=one"));
  }
  void edit(const std::string& from, const std::string& to, int age) {
    auto text = tyndall::readText(source_);
    ASSERT_TRUE(text);
    const auto at = text->find(from);
    ASSERT_NE(at, std::string::npos);
    text->replace(at, from.size(), to);
    ASSERT_TRUE(writeTextAtomically(source_, *text));
    fs::last_write_time(source_, fs::file_time_type::clock::now() + std::chrono::seconds(age));
  }
};

TEST_F(Reload, newCodeRunsAndBrokenCodeDoesNot) {
  EXPECT_EQ(frame().at(0, 0), glm::vec4(1 + 1, 1, 0.25f, 0.5f));
  EXPECT_TRUE(effect_->reloadShaders().empty());
  edit("0.5)", "0.75)", 10);
  const auto changed = effect_->reloadShaders();
  ASSERT_EQ(changed.size(), 1u);
  EXPECT_THAT(changed[0], HasSubstr("accumulate.comp"));
  EXPECT_EQ(frame().at(0, 0), glm::vec4(2 + 1, 2, 0.25f, 0.75f)) << "with the same layout and history";
  edit("0.75)", "0.125", 20);  // a bracket is missing
  const auto broken = effect_->reloadShaders();
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_THAT(broken[0], HasSubstr("accumulate.comp"));
  EXPECT_EQ(frame().at(0, 0), glm::vec4(3 + 1, 3, 0.25f, 0.75f)) << "the last good code";
  edit("binding = 1)", "binding = 9)", 30);
  edit("0.125", "0.125)", 40);  // compiles, but disagrees with the table
  const auto disagreeing = effect_->reloadShaders();
  ASSERT_EQ(disagreeing.size(), 2u);
  EXPECT_THAT(disagreeing[1], HasSubstr("declares binding 9"));
  EXPECT_EQ(frame().at(0, 0), glm::vec4(4 + 1, 4, 0.25f, 0.75f));
}

}  // namespace
}  // namespace tyndall::host
