#include <algorithm>

#include <gtest/gtest.h>

#include "pass_history.hpp"

namespace tyndall::editor {
namespace {

render::PassTime pass(const char* name, const char* owner, double ms) {
  render::PassTime time;
  time.name = name, time.owner = owner, time.milliseconds = ms;
  return time;
}

TEST(PassHistory, MedianAndWorstAreOfTheWindow) {
  PassHistory history;
  history.add({pass("a", "engine", 1000)});  // leaves the window
  for (std::size_t i = 1; i <= PassHistory::kFrames; ++i)
    history.add({pass("a", "engine", static_cast<double>(i)), pass("b", "plugin", 2), pass("copy", "editor", 77),
                 pass("copy", "readback", 77)});
  ASSERT_EQ(history.frames().size(), PassHistory::kFrames);
  const auto lines = history.lines();
  ASSERT_EQ(lines.size(), 2u);  // the editor's own do not count
  EXPECT_EQ(lines[0].current, 120);
  EXPECT_EQ(lines[0].worst, 120);
  EXPECT_EQ(lines[0].median, 60.5);  // of 1 to 120
  EXPECT_EQ(history.total().current, 122);
  EXPECT_EQ(history.total().median, 62.5);
  ASSERT_EQ(history.owners().size(), 2u);
  EXPECT_EQ(history.owners()[1].owner, "plugin");
  EXPECT_EQ(history.owners()[1].worst, 2);
}

TEST(PassHistory, APassThatNoLongerRunsIsShownUntilItLeavesTheWindow) {
  PassHistory history;
  history.add({pass("old", "plugin", 5), pass("a", "engine", 1)});
  history.add({pass("a", "engine", 3)});
  auto lines = history.lines();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].name, "a");
  EXPECT_EQ(lines[0].median, 2);
  EXPECT_EQ(lines[1].name, "old");
  EXPECT_FALSE(lines[1].ran);
  EXPECT_EQ(lines[1].current, 0);
  EXPECT_EQ(lines[1].worst, 5);
  for (std::size_t i = 0; i < PassHistory::kFrames; ++i) history.add({pass("a", "engine", 1)});
  EXPECT_EQ(history.lines().size(), 1u);
}

TEST(PassHistory, PassesOfOneNameAddUp) {
  PassHistory history;
  history.add({pass("a", "engine", 1), pass("a", "engine", 2)});
  EXPECT_EQ(history.lines()[0].current, 3);
}

}  // namespace
}  // namespace tyndall::editor
