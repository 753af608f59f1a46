// What the hands do: commands, flight, and Esc.
#include <algorithm>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>  // which window is on top

#include "base/memory.hpp"
#include "editor.hpp"

namespace tyndall::editor {
namespace {

constexpr double kWatchSeconds = 1;        // how long a window sleeps in which nothing happens: files are looked at
constexpr double kBuildingSeconds = 0.01;  // the same while something is built beside the frames
constexpr double kStillSeconds = 2;        // without a new picture: freed memory goes back to the system

}  // namespace

void Editor::steer() {
  const ImGuiIO& io = ImGui::GetIO();
  const float passed = input_->seconds();
  if (workspace_.playing) workspace_.seconds += static_cast<double>(passed);
  for (const Command command : commandsOf(input_->presses(), io.WantTextInput)) perform(command);

  Flight flight;
  flying_ = false;
  float seconds = 0;  // of the flight: the longest that a key was down
  const bool flies = !io.WantTextInput && !io.KeyCtrl;
  for (const FlightKey& key : flightKeys()) {
    const float held = flies ? input_->held(key.key) : 0;
    if (held > 0) flight.push += key.push;
    seconds = std::max(seconds, held);
    flying_ = flying_ || (flies && input_->isDown(key.key));
  }
  flight.fast = input_->held(GLFW_KEY_LEFT_SHIFT) > 0 || input_->held(GLFW_KEY_RIGHT_SHIFT) > 0;
  if (looking_) flight.look = {io.MouseDelta.x, io.MouseDelta.y};
  if (orbiting_) flight.orbit = {io.MouseDelta.x, io.MouseDelta.y}, flight.pivot = orbitPivot_;
  if (viewHovered_) flight.wheel = io.MouseWheel;
  if (const auto wanted = std::exchange(workspace_.cameraWanted, std::nullopt)) {
    options_.camera = *wanted;
    workspace_.cameraReset = workspace_.changed = true;
  }
  if (std::exchange(workspace_.cameraReset, false)) {
    if (camera_->flown()) workspace_.changed = true;
    camera_->reset();
    flight = {};
  }
  if (camera_->fly(flight, seconds, fileCamera())) workspace_.changed = true;
  moving_ = flying_ || looking_ || orbiting_;
}

void Editor::closeTop() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.OpenPopupStack.Size > 0) return ImGui::ClosePopupToLevel(context.OpenPopupStack.Size - 1, true);
  for (int i = context.Windows.Size - 1; i >= 0; --i) {
    ImGuiWindow* window = context.Windows[i];
    const bool child = (window->Flags & ImGuiWindowFlags_ChildWindow) != 0;
    // As if its cross were clicked: each window knows what closing means.
    if (window->Active && window->HasCloseButton && !child) return ImGui::ActivateItem(window->GetID("#CLOSE"));
  }
  input_->letGo();
  ImGui::ClearActiveID();
}

/// Sleeps while there is nothing to draw and nothing has happened.
void Editor::awaitEvents() {
  const auto background = session_->background();
  if (drawDue()) {
    window_->poll();
  } else {
    double seconds = kWatchSeconds;
    if (background == host::PluginEffect::Background::kBuilding) seconds = kBuildingSeconds;
    seconds = std::min(seconds, redrawAt_ - glfwGetTime());
    window_->wait(std::max(seconds, 1e-3));
  }
  const double now = glfwGetTime();
  watcher_.check(*session_, workspace_);
  const bool told = std::exchange(workspace_.told, false);
  const bool built = std::exchange(backgroundSeen_, background) != background;
  const bool woken = woken_.exchange(false);
  if (input_->takeNews() || woken || told || built) toDraw_ = kSettledFrames;
  if (now >= redrawAt_) toDraw_ = std::max(toDraw_, 1u), redrawAt_ = kNever;
  if (!memoryReturned_ && !drawDue() && background != host::PluginEffect::Background::kBuilding &&
      now - pictureTime_ > kStillSeconds)
    returnFreeMemory(), memoryReturned_ = true;
}

bool Editor::drawDue() const {
  return toDraw_ > 0 || frames_ < kSettledFrames || flying_ || stress_ || options_.frames > 0 || pictureWanted();
}

}  // namespace tyndall::editor
