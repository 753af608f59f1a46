// Levels and presets from files, and what is remembered between runs.
#include "editor.hpp"

#include <algorithm>

#include "app/presets.hpp"
#include "recovery.hpp"

namespace tyndall::editor {

namespace fs = std::filesystem;

Editor::Editor(const Options& options)
    : options_(options),
      // Random use and pictures of N frames are no user's session: they leave no trace unless a file is named.
      settingsFile_(!options.settings.empty()                  ? options.settings
                    : options.frames > 0 || options.stress > 0 ? fs::path()
                                                               : settingsPath()),
      state_(options.state) {}

std::string Editor::levelText() const {
  const app::Level& level = *session_->level();
  const bool sample =
      level.name.find('/') == std::string::npos && !level.name.ends_with(".gltf") && !level.name.ends_with(".glb");
  std::error_code unknown;
  return sample ? level.name : fs::absolute(level.path, unknown).string();
}

void Editor::noticeLevel() {
  if (session_->levelsSet() == levelsSeen_) return;
  levelsSeen_ = session_->levelsSet();
  level_.reset(session_->editScene());
  editsSeen_ = {};
  history_.clear();  // its cameras and edits are of another place
  times_.restart();
  ++workspace_.levelEdits;
}

void Editor::openLevel(const std::string& text) {
  auto level = app::loadLevel(text);
  if (!level) return workspace_.tell(level.error().message, true);
  app::Level before = *session_->level();
  std::vector<std::string> told = level->warnings;
  told.insert(told.end(), level->notes.begin(), level->notes.end());
  const scene::Bounds bounds = scene::worldBounds(level->scene, level->worldFromNode(0));
  if (auto set = session_->setLevel(level.take()); !set) {
    const std::string reason = set.error().message;
    if (auto back = session_->setLevel(std::move(before)); !back) levelLost_ = back.error();
    return workspace_.tell(reason + "; the level before stays", true);
  }
  noticeLevel();
  camera_.emplace(bounds.empty() ? 10.0f : glm::length(bounds.max - bounds.min));
  workspace_.seconds = 0, workspace_.playing = false, workspace_.changed = true;
  options_.camera = 0;
  settings_.opened(levelText());
  window_->setTitle("Tyndall - " + session_->level()->name);
  workspace_.tell(told.empty() ? "opened " + session_->level()->name : told.front(), false);
}

void Editor::browse(Command command) {
  filesFor_ = command;
  // Names as the command line takes them: a sample's, a preset's.
  const auto level = [](const std::string& text) -> std::optional<fs::path> {
    const std::vector<std::string> samples = app::sampleLevels();
    if (std::find(samples.begin(), samples.end(), text) == samples.end()) return std::nullopt;
    return fs::path(text);
  };
  const auto preset = [](const std::string& text) -> std::optional<fs::path> {
    auto found = app::findPreset(text);
    std::error_code unknown;
    return found && fs::exists(*found, unknown) ? std::optional(found.take()) : std::nullopt;
  };
  if (command == Command::kOpenLevel)
    files_.open("Open level", FileBrowser::Mode::kOpen, {".gltf", ".glb"}, settings_.levelFolder, level);
  else if (command == Command::kSavePreset)
    files_.open("Save preset", FileBrowser::Mode::kSave, {".json"}, settings_.presetFolder);
  else
    files_.open(command == Command::kLoadPreset ? "Load preset" : "Compare with preset", FileBrowser::Mode::kOpen,
                {".json"}, settings_.presetFolder, preset);
}

void Editor::fileChosen(const fs::path& file) {
  const std::string folder = file.parent_path().string(), name = file.string();
  if (filesFor_ == Command::kOpenLevel) {
    if (!folder.empty()) settings_.levelFolder = folder;  // a sample's name has none
    levelAsked_ = name;
    return;
  }
  if (file.parent_path() != app::presetFolder()) settings_.presetFolder = folder;
  if (filesFor_ == Command::kComparePreset) {
    compared_ = file;
    return;
  }
  const bool load = filesFor_ == Command::kLoadPreset;
  auto done = load ? loadPreset(session_->table(), file) : savePreset(session_->table(), file);
  if (!done) return workspace_.tell(done.error().message, true);
  if (load) workspace_.changed = true;
  workspace_.tell((load ? "loaded " : "saved ") + name, false);
}

void Editor::drawComparison() {
  if (compared_.empty()) return;
  bool open = true;
  ImGui::SetNextWindowSize({scaled(380), scaled(200)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos({100, 90}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Compare with preset", &open, ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::TextColored(kDimColor, "%s", compared_.string().c_str());
    // Read again in each frame: the file may be written by another hand, and is a page of text.
    workspace_.drawAgain(1);
    auto differences = comparePreset(session_->table(), compared_);
    if (!differences)
      ImGui::TextColored(kErrorColor, "%s", differences.error().message.c_str());
    else if (differences->empty())
      ImGui::TextUnformatted("no value differs");
    else if (ImGui::BeginTable("values", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
      for (const char* title : {"parameter", "here", "preset"}) ImGui::TableSetupColumn(title);
      ImGui::TableHeadersRow();
      for (const Difference& difference : *differences) {
        ImGui::TableNextRow();
        for (const std::string* text : {&difference.id, &difference.here, &difference.there}) {
          ImGui::TableNextColumn();
          ImGui::TextUnformatted(text->c_str());
        }
      }
      ImGui::EndTable();
    }
    workspace_.facts["compare.count"] = differences ? std::to_string(differences->size()) : "failed";
  }
  ImGui::End();
  if (!open) compared_.clear();
}

std::string Editor::keepEdits() const {
  const fs::path folder = settingsFile_.folder();
  if (folder.empty() || !history_.canUndo()) return "";
  const app::Level* level = session_->level();
  const bool edited = level && !editsOf(level->scene, level_.file()).empty();
  auto kept = writeRecovery(folder, session_->table(), edited ? &level->scene : nullptr);
  return kept ? "; what was edited is kept in " + *kept : "; what was edited is lost: " + kept.error().message;
}

void Editor::keepSettings() {
  capture_.keep(settings_);
  if (ImGui::IsAnyItemActive()) return;  // a text is being typed
  if (auto written = settingsFile_.write(settings_); !written)
    workspace_.tell("settings: " + written.error().message, true);
}

}  // namespace tyndall::editor
