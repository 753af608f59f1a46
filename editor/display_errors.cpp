#include "display_errors.hpp"

#ifdef TYNDALL_X11
#include <string>
#include <utility>

#include <X11/Xlib.h>

#include "base/log.hpp"
#endif

namespace tyndall::editor {
#ifdef TYNDALL_X11
namespace {

std::function<void()>& lastCall() {
  static std::function<void()> call;
  return call;
}

/// The X library calls it in the middle of something else: nothing may be asked of the server here.
int tell(Display* display, XErrorEvent* error) {
  char text[256] = "";
  XGetErrorText(display, error->error_code, text, sizeof text);
  log::warning("window: the X server refused request " + std::to_string(error->request_code) + "." +
               std::to_string(error->minor_code) + ": " + text);
  return 0;  // ignored
}

int lost(Display*) {
  // Once only: what is done here may notice the loss as well.
  if (const auto call = std::exchange(lastCall(), nullptr)) call();
  return 0;  // ignored
}

}  // namespace

void outliveDisplayErrors() { XSetErrorHandler(tell); }

void onDisplayLost(std::function<void()> last) {
  lastCall() = std::move(last);
  XSetIOErrorHandler(lost);
}
#else
void outliveDisplayErrors() {}
void onDisplayLost(std::function<void()>) {}
#endif

}  // namespace tyndall::editor
