// The table of commands and what it makes of keys.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

#include "shortcuts.hpp"

namespace tyndall::editor {
namespace {

TEST(Shortcuts, EachRowIsReachedByItsKeysAndNoOther) {
  std::set<std::tuple<int, bool, bool>> seen;
  for (const Shortcut& shortcut : shortcuts()) {
    if (shortcut.key == 0) continue;
    EXPECT_TRUE(seen.insert({shortcut.key, shortcut.control, shortcut.shift}).second) << shortcut.key;
    const KeyPress press{shortcut.key, shortcut.control, shortcut.shift};
    const auto commands = commandsOf({&press, 1}, false);
    ASSERT_EQ(commands.size(), 1u);
    EXPECT_EQ(commands[0], shortcut.command);
    // What is shown says which of the two keys is held with it.
    if (!shortcut.keys) continue;
    const std::string keys = shortcut.keys;
    EXPECT_EQ(keys.find("Ctrl+") != std::string::npos, shortcut.control) << keys;
    EXPECT_EQ(keys.find("Shift+") != std::string::npos, shortcut.shift) << keys;
  }
  // Two presses in one frame are two commands.
  const KeyPress undo{'Z', true, false};
  const KeyPress twice[] = {undo, undo};
  EXPECT_EQ(commandsOf(twice, false), (std::vector<Command>{Command::kUndo, Command::kUndo}));
  EXPECT_TRUE(commandsOf(twice, true).empty());  // a field undoes its own typing
}

}  // namespace
}  // namespace tyndall::editor
