#include "file_browser.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

namespace tyndall::editor {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

void FileBrowser::open(std::string title, Mode mode, std::vector<std::string> extensions, const fs::path& folder,
                       Named named) {
  title_ = std::move(title), mode_ = mode, extensions_ = std::move(extensions), named_ = std::move(named);
  open_ = appearing_ = true;
  name_ = {};
  std::error_code unknown;
  go(fs::is_directory(folder, unknown) ? folder : fs::current_path(unknown));
}

void FileBrowser::go(const fs::path& folder) {
  std::error_code unknown;
  const fs::path whole = fs::weakly_canonical(folder, unknown);
  folder_ = unknown ? folder : whole;
  read();
}

void FileBrowser::read() {
  entries_.clear();
  problem_.clear();
  replace_ = false;
  std::error_code unreadable;
  for (fs::directory_iterator at(folder_, unreadable), end; !unreadable && at != end; at.increment(unreadable)) {
    std::error_code unknown;  // a link to nothing, say: shown as neither
    const std::string name = at->path().filename().string();
    if (name.starts_with('.')) continue;
    if (at->is_directory(unknown))
      entries_.push_back({name, true});
    else if (std::find(extensions_.begin(), extensions_.end(), lower(at->path().extension().string())) !=
             extensions_.end())
      entries_.push_back({name, false});
  }
  if (unreadable) problem_ = "this folder cannot be read: " + unreadable.message();
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

std::optional<fs::path> FileBrowser::accept() {
  const std::string text = name_.data();
  if (text.empty()) return std::nullopt;
  fs::path path = folder_ / text;  // an absolute path replaces the folder
  std::error_code unknown;
  if (fs::is_directory(path, unknown)) {
    name_ = {};
    go(path);
    return std::nullopt;
  }
  if (mode_ == Mode::kSave && lower(path.extension().string()) != extensions_.front()) path += extensions_.front();
  const bool exists = fs::exists(path, unknown);
  if (mode_ == Mode::kOpen && !exists) {
    if (const auto known = named_ ? named_(text) : std::nullopt) {
      open_ = false;
      return known;
    }
    problem_ = "there is no such file";
    return std::nullopt;
  }
  if (mode_ == Mode::kSave && exists && !replace_) {
    replace_ = true;
    problem_ = path.filename().string() + " exists; once more replaces it";
    return std::nullopt;
  }
  open_ = false;
  return path;
}

std::optional<fs::path> FileBrowser::draw(Workspace& workspace) {
  if (!open_) return std::nullopt;
  std::optional<fs::path> chosen;
  ImGui::SetNextWindowSize({scaled(420), scaled(320)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos({80, 70}, ImGuiCond_FirstUseEver);
  const bool appearing = std::exchange(appearing_, false);
  if (appearing) ImGui::SetNextWindowFocus();
  if (ImGui::Begin((title_ + "###files").c_str(), &open_,
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse)) {
    if (ImGui::Button("up")) go(folder_.parent_path());
    workspace.place("file up");
    ImGui::SameLine();
    ImGui::TextUnformatted(folder_.string().c_str());
    std::optional<Entry> clicked;
    ImGui::BeginChild("entries", {0, -2 * ImGui::GetFrameHeightWithSpacing()}, true);
    for (const Entry& entry : entries_) {
      if (ImGui::Selectable((entry.name + (entry.folder ? "/" : "")).c_str(), entry.name == name_.data(),
                            ImGuiSelectableFlags_AllowDoubleClick))
        clicked = entry;
      workspace.place("file " + entry.name);
    }
    ImGui::EndChild();
    if (appearing) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-scaled(80));
    bool taken = ImGui::InputText("##name", name_.data(), name_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemEdited()) replace_ = false, problem_.clear();
    workspace.place("file name");
    ImGui::SameLine();
    taken = ImGui::Button(mode_ == Mode::kOpen ? "open" : "save") || taken;
    workspace.place("file accept");
    if (!problem_.empty()) ImGui::TextColored(kErrorColor, "%s", problem_.c_str());
    if (clicked && clicked->folder) {
      go(folder_ / clicked->name);
    } else if (clicked) {
      std::snprintf(name_.data(), name_.size(), "%s", clicked->name.c_str());
      replace_ = false, problem_.clear();
      taken = taken || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    if (taken) chosen = accept();
    if (ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
        ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
      open_ = false;
  }
  ImGui::End();
  return chosen;
}

}  // namespace tyndall::editor
