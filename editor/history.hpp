// Undo and redo. The history is not told of edits, it sees them: whatever changes the state - a slider, a preset, a
// click into a plot, a flight - is a step once the hand is off it. Knows neither window nor device.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pose.hpp"
#include "params/params.hpp"
#include "scene_edits.hpp"

namespace tyndall::editor {

/// All that an edit can change. Settings: those set explicitly, as text (a reloaded plugin may number its choices
/// anew); the others have their defaults.
struct EditState {
  std::map<std::string, std::string> settings;
  std::optional<app::Pose> pose;  ///< of a camera that was flown
  std::uint32_t camera = 0;       ///< of the file's: which one is looked through, or was before the flight
  SceneEdits scene;               ///< what of the level differs from the file
  bool operator==(const EditState&) const = default;
};

std::map<std::string, std::string> settingsOf(const params::Table& table);
/// Sets exactly these. Values that the table refuses (a plugin was reloaded that lacks them) keep their defaults; the
/// reasons, one line each.
std::vector<std::string> applySettings(params::Table& table, const std::map<std::string, std::string>& settings);

class History {
 public:
  struct Step {
    std::string label;  ///< "Steps 32 -> 64", "camera", "5 settings"
    std::shared_ptr<const EditState> after;
  };
  /// The state now; `busy`: the mouse still drags, or the camera flies. A state that differs from the present one when
  /// the hand is off becomes a step; what was undone before it is forgotten. True: a step was added.
  bool observe(const params::Table& table, const EditState& now, bool busy);
  /// Everything is forgotten; the next state observed is where undoing ends.
  void clear();

  bool canUndo() const { return present_ > 0; }
  bool canRedo() const { return present_ + 1 < steps_.size(); }
  /// The state to go to, which is then the present one; null: there is none.
  const EditState* undo() { return canUndo() ? jump(present_ - 1) : nullptr; }
  const EditState* redo() { return canRedo() ? jump(present_ + 1) : nullptr; }
  const EditState* jump(std::size_t step);

  /// The first one is the state that undoing ends at.
  const std::vector<Step>& steps() const { return steps_; }
  std::size_t present() const { return present_; }

 private:
  std::vector<Step> steps_;
  std::size_t present_ = 0;
};

}  // namespace tyndall::editor
