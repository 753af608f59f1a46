#include "input.hpp"

#include <algorithm>
#include <cfloat>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace tyndall::editor {
namespace {

using Kind = InputEvent::Kind;

// A window opened by a click is laid out in its first frame, shown in its second; a field that is to get the keys has
// them in the one after.
constexpr int kSettleFrames = 3;
constexpr double kShortestTap = 1.0 / 60;  // seconds
constexpr float kLeastSeconds = 1e-6f;     // Dear ImGui takes no frame of 0

Input& inputOf(GLFWwindow* window) { return *static_cast<Input*>(glfwGetWindowUserPointer(window)); }

struct NamedKey {
  ImGuiKey_ imgui;
  int glfw;
};
constexpr NamedKey kKeys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
                              {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                              {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                              {ImGuiKey_UpArrow, GLFW_KEY_UP},
                              {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                              {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                              {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                              {ImGuiKey_Home, GLFW_KEY_HOME},
                              {ImGuiKey_End, GLFW_KEY_END},
                              {ImGuiKey_Insert, GLFW_KEY_INSERT},
                              {ImGuiKey_Delete, GLFW_KEY_DELETE},
                              {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                              {ImGuiKey_Space, GLFW_KEY_SPACE},
                              {ImGuiKey_Enter, GLFW_KEY_ENTER},
                              {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                              {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                              {ImGuiKey_A, GLFW_KEY_A},
                              {ImGuiKey_C, GLFW_KEY_C},
                              {ImGuiKey_V, GLFW_KEY_V},
                              {ImGuiKey_X, GLFW_KEY_X},
                              {ImGuiKey_Y, GLFW_KEY_Y},
                              {ImGuiKey_Z, GLFW_KEY_Z}};

constexpr std::pair<ImGuiMouseCursor_, int> kCursors[] = {{ImGuiMouseCursor_Arrow, GLFW_ARROW_CURSOR},
                                                          {ImGuiMouseCursor_TextInput, GLFW_IBEAM_CURSOR},
                                                          {ImGuiMouseCursor_ResizeNS, GLFW_VRESIZE_CURSOR},
                                                          {ImGuiMouseCursor_ResizeEW, GLFW_HRESIZE_CURSOR},
                                                          {ImGuiMouseCursor_Hand, GLFW_HAND_CURSOR}};

}  // namespace

Input::Input(Window& window) : window_(window), time_(glfwGetTime()) { setUp(); }

Input::~Input() {
  GLFWwindow* window = window_.handle();
  glfwSetMouseButtonCallback(window, nullptr), glfwSetCursorPosCallback(window, nullptr);
  glfwSetCursorEnterCallback(window, nullptr), glfwSetScrollCallback(window, nullptr);
  glfwSetKeyCallback(window, nullptr), glfwSetCharCallback(window, nullptr);
  glfwSetWindowFocusCallback(window, nullptr), glfwSetWindowRefreshCallback(window, nullptr);
  glfwSetWindowIconifyCallback(window, nullptr), glfwSetFramebufferSizeCallback(window, nullptr);
  glfwSetWindowContentScaleCallback(window, nullptr);
  glfwSetWindowUserPointer(window, nullptr);
  for (GLFWcursor* cursor : cursors_)
    if (cursor) glfwDestroyCursor(cursor);
}

void Input::setUp() {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  io.BackendPlatformName = "tyndall";
  for (const NamedKey& key : kKeys) io.KeyMap[key.imgui] = key.glfw;
  // A key that is held repeats by the window system's events, which are not lost in a slow frame.
  io.KeyRepeatDelay = FLT_MAX;
  io.ConfigInputTextCursorBlink = false;  // a window that blinks is drawn for nothing
  io.GetClipboardTextFn = [](void* window) { return glfwGetClipboardString(static_cast<GLFWwindow*>(window)); };
  io.SetClipboardTextFn = [](void* window, const char* text) {
    glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
  };
  GLFWwindow* window = window_.handle();
  io.ClipboardUserData = window;
  cursors_.assign(ImGuiMouseCursor_COUNT, nullptr);
  for (const auto& [cursor, shape] : kCursors)
    cursors_[static_cast<std::size_t>(cursor)] = glfwCreateStandardCursor(shape);

  glfwSetWindowUserPointer(window, this);
  // The place that the mouse is at before it moves.
  double x = 0, y = 0;
  glfwGetCursorPos(window, &x, &y);
  queue_.add({.kind = Kind::kMotion, .seconds = time_, .at = {x, y}});
  static const auto add = [](GLFWwindow* from, InputEvent event) {
    Input& input = inputOf(from);
    event.seconds = glfwGetTime();
    input.queue_.add(event);
    input.news_ = true;
  };
  static const auto news = [](GLFWwindow* from) { inputOf(from).news_ = true; };
  glfwSetMouseButtonCallback(window, [](GLFWwindow* from, int button, int action, int) {
    add(from, {.kind = Kind::kButton, .code = button, .down = action == GLFW_PRESS});
  });
  glfwSetCursorPosCallback(window, [](GLFWwindow* from, double right, double down) {
    add(from, {.kind = Kind::kMotion, .at = {right, down}});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* from, int entered) {
    if (!entered) return add(from, {.kind = Kind::kLeave});
    double right = 0, down = 0;
    glfwGetCursorPos(from, &right, &down);
    add(from, {.kind = Kind::kMotion, .at = {right, down}});
  });
  glfwSetScrollCallback(window, [](GLFWwindow* from, double right, double up) {
    add(from, {.kind = Kind::kWheel, .at = {right, up}});
  });
  glfwSetKeyCallback(window, [](GLFWwindow* from, int key, int scancode, int action, int) {
    if (key == GLFW_KEY_UNKNOWN) return;
    const int named = inputOf(from).namedKey(key, scancode);
    InputEvent event{.kind = Kind::kKey, .code = key, .named = named, .down = true, .repeated = action == GLFW_REPEAT};
    // A repeat is a key that went up and down once more: what is typed into sees only edges.
    if (event.repeated) event.down = false, add(from, event);
    event.down = action != GLFW_RELEASE;
    add(from, event);
  });
  glfwSetCharCallback(window,
                      [](GLFWwindow* from, unsigned int text) { add(from, {.kind = Kind::kText, .text = text}); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* from, int) { news(from); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* from) { news(from); });
  glfwSetWindowIconifyCallback(window, [](GLFWwindow* from, int) { news(from); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* from, int, int) { news(from); });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* from, float, float) { news(from); });
}

/// Letters by what is printed on the key: Ctrl+Z is where the keyboard's Z is. Others by their place.
int Input::namedKey(int key, int scancode) const {
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || name[0] == 0 || name[1] != 0) return key;
  if (name[0] >= 'a' && name[0] <= 'z') return GLFW_KEY_A + (name[0] - 'a');
  if (name[0] >= 'A' && name[0] <= 'Z') return GLFW_KEY_A + (name[0] - 'A');
  return key;
}

bool Input::takeNews() { return std::exchange(news_, false); }

void Input::beginFrame(double now) {
  ImGuiIO& io = ImGui::GetIO();
  presses_.clear();
  before_ = down_;
  double end = queue_.empty() && settling_ == 0 ? now : time_;
  if (settling_ > 0) {
    --settling_;
  } else if (const std::vector<InputEvent> step = queue_.take(); !step.empty()) {
    end = step.front().seconds;
    for (const InputEvent& event : step) apply(event);
    const InputEvent& first = step.front();
    const bool edge = first.kind == Kind::kButton || (first.kind == Kind::kKey && first.down && !first.repeated);
    // What is typed changes nothing but the text, and a motion only what is under the mouse.
    if (edge && step.size() == 1) settling_ = kSettleFrames;
    if (first.kind == Kind::kMotion && queue_.pressNext()) settling_ = 1;
  }
  end = std::max(end, time_);
  seconds_ = static_cast<float>(end - std::exchange(time_, end));
  io.DeltaTime = std::max(seconds_, kLeastSeconds);

  int width = 0, height = 0;
  glfwGetWindowSize(window_.handle(), &width, &height);
  const auto [across, along] = window_.pixels();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  if (width > 0 && height > 0)
    io.DisplayFramebufferScale = {static_cast<float>(across) / io.DisplaySize.x,
                                  static_cast<float>(along) / io.DisplaySize.y};
  showCursor();
}

void Input::apply(const InputEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case Kind::kMotion:
      inside_ = true;
      io.MousePos = {event.at.x, event.at.y};
      return;
    case Kind::kLeave: inside_ = false; break;
    case Kind::kButton: {
      const auto button = static_cast<std::size_t>(event.code);
      if (button >= buttons_.size()) return;
      buttons_[button] = event.down;
      io.MouseDown[button] = event.down;
      break;
    }
    case Kind::kWheel: io.MouseWheelH += event.at.x, io.MouseWheel += event.at.y; return;
    case Kind::kKey: return applyKey(event);
    case Kind::kText: io.AddInputCharacter(event.text); return;
  }
  // What is dragged out of the window is still dragged.
  const bool held = std::find(buttons_.begin(), buttons_.end(), true) != buttons_.end();
  if (!inside_ && !held) io.MousePos = {-FLT_MAX, -FLT_MAX};
}

void Input::applyKey(const InputEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  if (event.repeated && !io.WantTextInput) return;  // only what is typed repeats
  io.KeysDown[event.named] = event.down;
  if (!event.repeated && event.down) down_[event.code] = event.seconds;
  if (!event.repeated && !event.down) down_.erase(event.code);
  const auto either = [&](int left, int right) { return isDown(left) || isDown(right); };
  io.KeyCtrl = either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  io.KeyShift = either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  io.KeyAlt = either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  io.KeySuper = either(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
  if (event.down && !event.repeated) presses_.push_back({event.named, io.KeyCtrl, io.KeyShift});
}

float Input::held(int key) const {
  const auto since = before_.find(key);
  if (since == before_.end()) return 0;
  const double tap = time_ - since->second;
  const bool released = !down_.contains(key);
  return seconds_ + static_cast<float>(released ? std::max(kShortestTap - tap, 0.0) : 0);
}

void Input::letGo() {
  buttons_.fill(false);
  for (bool& down : ImGui::GetIO().MouseDown) down = false;
}

void Input::showCursor() {
  const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
  if (wanted == ImGuiMouseCursor_None) return;
  GLFWcursor* cursor = cursors_[static_cast<std::size_t>(wanted)];
  glfwSetCursor(window_.handle(), cursor ? cursor : cursors_[ImGuiMouseCursor_Arrow]);
}

}  // namespace tyndall::editor
