// What the hand did, in its order and with its times: a picture may take longer than a click. The interface takes it in
// steps that one of its frames can tell apart. Knows neither window nor Dear ImGui.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <glm/glm.hpp>

namespace tyndall::editor {

struct InputEvent {
  enum class Kind { kMotion, kLeave, kButton, kWheel, kKey, kText };
  Kind kind = Kind::kMotion;
  double seconds = 0;      ///< when it happened
  glm::vec2 at{0};         ///< kMotion: points in the window. kWheel: notches, right and up
  int code = 0;            ///< kButton: GLFW_MOUSE_BUTTON_*; kKey: GLFW_KEY_*, by its place on the keyboard
  int named = 0;           ///< kKey: the same by what is printed on it
  bool down = false;       ///< kButton, kKey: it went down; else up
  bool repeated = false;   ///< kKey: it was down before
  std::uint32_t text = 0;  ///< kText: a code point
};

/// A key that went down, by what is printed on it, and what was held with it.
struct KeyPress {
  int key = 0;  ///< GLFW_KEY_*
  bool control = false, shift = false;
};

class InputQueue {
 public:
  void add(const InputEvent& event) { events_.push_back(event); }
  bool empty() const { return events_.empty(); }
  /// The oldest event with those that need no frame of their own: motion up to the next edge as its last place, turns
  /// of the wheel as their sum, a key with the text that it types. Empty where the queue is.
  std::vector<InputEvent> take();
  /// What take() gives next begins with a button or key that goes down.
  bool pressNext() const;

 private:
  std::deque<InputEvent> events_;
};

}  // namespace tyndall::editor
