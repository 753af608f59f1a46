// Errors of the X server. Left to itself the X library ends the program at each: also where another program asked for
// the clipboard and went away. Does nothing where there is no X library, or another window system.
#pragma once

#include <functional>

namespace tyndall::editor {

/// From now on an error of the X server is a line in the log. Call it again once GLFW has made a window, which puts the
/// X library's own handler back.
void outliveDisplayErrors();

/// `last` is called when the connection to the X server is gone, on the thread that noticed; the program ends after
/// it, so it ends the program itself if it is to end in another way. Nothing of the window may be used there.
void onDisplayLost(std::function<void()> last);

}  // namespace tyndall::editor
