// What the menu's commands do, and how edits become steps that can be undone.
#include <utility>

#include "editor.hpp"

namespace tyndall::editor {

EditState Editor::editState() const {
  return {settingsOf(session_->table()), camera_->pose(), cameraIndex(),
          editsOf(session_->level()->scene, level_.file())};
}

void Editor::watchEdits() {
  const bool held = ImGui::IsAnyItemActive() || parameters_.pending();
  const EditState now = editState();
  // The research windows take a copy of the level for each edit of it: not while one is dragged.
  if (history_.observe(session_->table(), now, held || moving_) && now.scene != editsSeen_)
    editsSeen_ = now.scene, ++workspace_.levelEdits;
}

void Editor::restore(const EditState* state) {
  if (!state) return;
  const std::vector<std::string> refused = applySettings(session_->table(), state->settings);
  camera_->setPose(state->pose);
  options_.camera = state->camera;
  applyEdits(session_->editScene(), level_.file(), state->scene);
  if (state->scene != editsSeen_) editsSeen_ = state->scene, ++workspace_.levelEdits;
  workspace_.changed = true;
  if (!refused.empty())
    workspace_.tell("a value of then has no meaning now: " + refused.front(), true);
  else
    workspace_.tell(history_.steps()[history_.present()].label, false);
}

void Editor::takeCapture() {
  app::Capture view;
  view.level = levelText();
  view.camera = cameraIndex(), view.pose = camera_->pose();
  view.size = {viewWidth_, viewHeight_}, view.seconds = workspace_.seconds, view.debugView = workspace_.debugView;
  view.pluginFolder = options_.pluginFolder;
  auto done = capture_.take(*session_, view, !editState().scene.empty());
  workspace_.changed = true;
  if (!done) return workspace_.tell(done.error().message, true);
  workspace_.tell("captured; the command is in the clipboard", false);
}

void Editor::writeView() {
  const auto write = std::exchange(workspace_.writeView, nullptr);
  if (!write) return;
  const std::string stem = std::filesystem::path(levelText()).stem().string() + "-" + workspace_.writeViewName;
  const std::filesystem::path file = capture_.fileOf(capture_.freeName(stem, {".exr"}), ".exr");
  if (auto done = write(file); !done) return workspace_.tell(done.error().message, true);
  workspace_.tell("wrote " + file.string(), false);
}

void Editor::perform(Command command) {
  switch (command) {
    case Command::kUndo: return restore(history_.undo());
    case Command::kRedo: return restore(history_.redo());
    case Command::kHistory: historyOpen_ = !historyOpen_; return;
    case Command::kCloseTop: return closeTop();
    case Command::kHelp: helpOpen_ = !helpOpen_; return;
    case Command::kSearch: parameters_.search(); return;
    case Command::kResetCamera: workspace_.cameraReset = true; return;
    case Command::kQuit: window_->close(); return;
    case Command::kPanels: settings_.layout.panels = !settings_.layout.panels; return;
    case Command::kLargerText: settings_.layout.textScale = Layout::largerText(textScale_); return;
    case Command::kSmallerText: settings_.layout.textScale = Layout::smallerText(textScale_); return;
    case Command::kNormalText: settings_.layout.textScale = 0; return;
    case Command::kResetLayout: settings_.layout = {}; return;
    case Command::kOpenLevel:
    case Command::kLoadPreset:
    case Command::kSavePreset:
    case Command::kComparePreset: return browse(command);
    case Command::kCapture: capture_.open = !capture_.open; return;
    case Command::kResetAll:
      session_->table().resetToDefaults();
      workspace_.changed = true;
      workspace_.tell("every parameter has its default value", false);
      return;
  }
}

}  // namespace tyndall::editor
