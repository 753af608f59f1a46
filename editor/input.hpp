// The window's events for Dear ImGui and for the editor's own keys: both take them from one queue, step by step, so
// that they see the same in the same frame. Stands in for ImGui's GLFW backend, which samples the state once a frame.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "input_queue.hpp"
#include "window.hpp"

struct GLFWcursor;

namespace tyndall::editor {

class Input {
 public:
  /// Takes over the window's callbacks; a context of Dear ImGui is there. One at a time; the window outlives it.
  explicit Input(Window& window);
  ~Input();
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  /// Before ImGui::NewFrame(): hands over one step of what happened. Once all is handed over, the frame is of `now`,
  /// seconds of glfwGetTime().
  void beginFrame(double now);
  /// Further frames are needed before the window is drawn.
  bool pending() const { return !queue_.empty() || settling_ > 0; }
  /// Whether something happened that the window may show (input, its size, its exposure) since the last call.
  bool takeNews();

  // Of the frame begun last.
  float seconds() const { return seconds_; }  ///< since the frame before
  const std::vector<KeyPress>& presses() const { return presses_; }
  /// Seconds within this frame that the key was down. A shorter tap than a frame of 60 Hz counts as that long.
  float held(int key) const;
  bool isDown(int key) const { return down_.contains(key); }

  /// Buttons that are down count as let go of until they go down anew.
  void letGo();

 private:
  void setUp();
  void apply(const InputEvent& event);
  void applyKey(const InputEvent& event);
  void showCursor();
  int namedKey(int key, int scancode) const;

  Window& window_;
  InputQueue queue_;
  std::map<int, double> down_;    ///< keys that are down, and since when
  std::map<int, double> before_;  ///< the same as the frame began
  std::vector<KeyPress> presses_;
  std::array<bool, 5> buttons_{};
  bool inside_ = true;  ///< the mouse is in the window
  bool news_ = true;
  int settling_ = 0;  ///< frames without input that the interface needs before the next step
  double time_ = 0;   ///< the last frame's end
  float seconds_ = 0;
  std::vector<GLFWcursor*> cursors_;  ///< by ImGuiMouseCursor; null: as the arrow
};

}  // namespace tyndall::editor
