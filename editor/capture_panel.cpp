#include "capture_panel.hpp"

#include <cstdio>

#include "scene/write_glb.hpp"

namespace tyndall::editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPicture = ".png";
constexpr const char* kScatter = "-scatter.exr";
constexpr const char* kDepth = "-depth.exr";
constexpr const char* kView = "-view.exr";
constexpr const char* kStats = ".json";
constexpr const char* kLevel = ".glb";

}  // namespace

void CapturePanel::restore(const Settings& s) {
  picture = s.capturePicture, scatter = s.captureScatter, depth = s.captureDepth, stats = s.captureStats;
  view = s.captureView;
  std::snprintf(folder.data(), folder.size(), "%s", s.captureFolder.c_str());
}

void CapturePanel::keep(Settings& s) const {
  s.capturePicture = picture, s.captureScatter = scatter, s.captureDepth = depth, s.captureStats = stats;
  s.captureView = view;
  s.captureFolder = folder.data();
}

fs::path CapturePanel::fileOf(const std::string& base, const char* extension) const {
  std::error_code unknown;  // without a working folder the name stays relative, and writing it says what is wrong
  const fs::path asked = fs::path(folder.data()) / (base + extension), whole = fs::absolute(asked, unknown);
  return unknown ? asked : whole;
}

std::string CapturePanel::freeBase(const std::string& level) const {
  return freeName(fs::path(level).stem().string(), {kPicture, kScatter, kDepth, kView, kStats, kLevel});
}

std::string CapturePanel::freeName(const std::string& stem, std::initializer_list<const char*> extensions) const {
  for (int i = 1;; ++i) {
    char digits[16];
    std::snprintf(digits, sizeof digits, "-%03d", i);
    const std::string base = stem + digits;
    bool taken = false;
    std::error_code unreadable;
    for (const char* extension : extensions) taken = taken || fs::exists(fileOf(base, extension), unreadable);
    if (!taken) return base;
  }
}

Result<void> CapturePanel::take(app::Session& session, app::Capture shot, bool levelEdited) {
  base_ = freeBase(shot.level);
  if (picture) shot.picture = fileOf(base_, kPicture);
  if (scatter) shot.scatter = fileOf(base_, kScatter);
  if (depth) shot.depth = fileOf(base_, kDepth);
  if (view && !shot.debugView.empty()) shot.viewExr = fileOf(base_, kView);
  if (stats) shot.stats = fileOf(base_, kStats);
  if (levelEdited) {
    shot.level = fileOf(base_, kLevel).string();
    if (auto written = scene::writeGlb(session.level()->scene, shot.level); !written)
      return Error{"capture: " + written.error().message, written.error().kind};
  }
  // The frames of a capture are of the table's values, not of those before, as they may be while something is built.
  session.buildInBackground(false);
  auto done = app::capture(session, shot);
  session.buildInBackground(true);
  std::error_code gone;
  if (!done && levelEdited) std::filesystem::remove(shot.level, gone);
  if (!done) return Error{"capture: " + done.error().message, done.error().kind};
  command_ = app::shellLine(app::captureWords(session, shot));
  ImGui::SetClipboardText(command_.c_str());
  return {};
}

bool CapturePanel::draw(Workspace& workspace) {
  if (!command_.empty()) workspace.facts["capture.command"] = command_;
  if (!open) return false;
  bool pressed = false;
  ImGui::SetNextWindowPos({60, 60}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({scaled(340), 0}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Capture", &open, ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::Checkbox("picture", &picture), workspace.place("capture picture");
    ImGui::SameLine(), ImGui::Checkbox("radiance", &scatter), workspace.place("capture scatter");
    ImGui::SameLine(), ImGui::Checkbox("depth", &depth), workspace.place("capture depth");
    ImGui::SameLine(), ImGui::Checkbox("figures", &stats), workspace.place("capture stats");
    ImGui::BeginDisabled(workspace.debugView.empty());
    ImGui::Checkbox("numbers of the debug view", &view), workspace.place("capture view");
    ImGui::EndDisabled();
    ImGui::SetNextItemWidth(-ImGui::CalcTextSize("folder ").x);
    ImGui::InputTextWithHint("folder", "the working folder", folder.data(), folder.size());
    workspace.place("capture folder");
    const bool viewToo = view && !workspace.debugView.empty();
    ImGui::BeginDisabled(!picture && !scatter && !depth && !stats && !viewToo);
    pressed = ImGui::Button("capture");
    ImGui::EndDisabled();
    workspace.place("capture");
    if (!command_.empty()) {
      ImGui::SameLine();
      if (ImGui::Button("copy the command")) ImGui::SetClipboardText(command_.c_str());
      workspace.place("copy command");
      ImGui::TextColored(kDimColor, "%s", base_.c_str());
      ImGui::PushTextWrapPos(0);
      ImGui::TextUnformatted(command_.c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
  return pressed;
}

}  // namespace tyndall::editor
