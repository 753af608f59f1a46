// Random use of the editor: parameters, sizes, levels, views, reloads, faults of window system and memory. The program judges
// itself (editor/stress.cpp): validation messages, images and buffers that stay, errors without a reason.
#include "display.hpp"

namespace tyndall::editor_test {
namespace {

TEST_F(EditorTest, RandomUseBreaksNothing) {
  startEditor({"hall", "--size", "320x200", "--stress", TYNDALL_STRESS_STEPS, "--seed", "3", "--validate"});
  EXPECT_EQ(waitEditor(TYNDALL_STRESS_SECONDS), 0) << errors();
  EXPECT_EQ(errors().find("validation"), std::string::npos) << errors();
}

}  // namespace
}  // namespace tyndall::editor_test
