// Another program on the display, which the editor knows nothing of.
#pragma once

#include <string>

namespace tyndall::editor_test {

/// Asks for the clipboard's text and is gone before its owner can have answered, as `timeout` ends a tool that waits.
/// False: there is no such display.
bool askForClipboardAndGiveUp(const std::string& display);

}  // namespace tyndall::editor_test
