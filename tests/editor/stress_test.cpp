// Random use of the editor: parameters, sizes, levels, views, reloads, faults of window system and memory. The program
// judges itself (editor/stress.cpp): validation messages, images and buffers that stay, errors without a reason.
#include "display.hpp"
#include "tiny_level.hpp"

namespace tyndall::editor_test {
namespace {

TEST_F(EditorTest, RandomUseBreaksNothing) {
  // Home is a level of few draws: lavapipe keeps some 9 kB of each until the process ends.
  const std::filesystem::path home = folder_ / "tiny.glb";
  writeTinyLevel(home);
  startEditor({home.string(), "--size", "320x200", "--stress", TYNDALL_STRESS_STEPS, "--seed", "3", "--validate"});
  EXPECT_EQ(waitEditor(TYNDALL_STRESS_SECONDS), 0) << errors();
  EXPECT_EQ(errors().find("validation"), std::string::npos) << errors();
}

}  // namespace
}  // namespace tyndall::editor_test
