// What the editor's panels share: what the user has chosen, what is to be told, where the widgets are.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include <imgui.h>

#include "base/result.hpp"

namespace tyndall::editor {

struct Rect {
  float x = 0, y = 0, width = 0, height = 0;  ///< points from the window's upper left corner
};

struct Workspace {
  double seconds = 0;  ///< time of the level's animations
  bool playing = false;
  bool continuous = false;                    ///< render even when nothing has changed (to watch times)
  std::string debugView;                      ///< "" = the picture
  bool changed = true;                        ///< the picture is out of date
  bool cameraReset = false;                   ///< F, or its button
  std::optional<std::uint32_t> cameraWanted;  ///< of the file's: looked through from now on
  /// A viewer's numbers are to be written as they are now: name of the view, and how. Done by the editor, which knows
  /// the folder.
  std::function<Result<void>(const std::filesystem::path&)> writeView;
  std::string writeViewName;
  bool reloadPlugin = false, reloadShaders = false;
  std::string message;  ///< the newest, one line
  bool messageIsError = false;
  bool told = false;             ///< since the window was drawn last
  double redrawIn = 1e30;        ///< seconds until the window is drawn again though nothing has happened
  std::uint32_t levelEdits = 0;  ///< grows whenever the level in the session is another, or changed
  std::map<std::string, std::string>
      facts;                            ///< what research panels show, by name: for scripts that read the state file
  std::map<std::string, Rect> widgets;  ///< of the frame drawn last, by parameter id or name

  void tell(std::string line, bool isError) {
    told = told || line != message || isError != messageIsError;
    message = std::move(line);
    messageIsError = isError;
  }
  /// The window is drawn only when something has happened. What changes by itself asks in each frame for the next.
  void drawAgain(double in) { redrawIn = std::min(redrawIn, in); }
  /// Notes where the widget drawn last is.
  void place(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    widgets[name] = {low.x, low.y, high.x - low.x, high.y - low.y};
  }
};

/// Height of the text's normal size, points: that which Dear ImGui's own font is drawn for.
inline constexpr float kTextHeight = 13;
/// Points, from those at the text's normal size.
inline float scaled(float points) { return points * ImGui::GetFontSize() / kTextHeight; }

/// Theme.
inline const ImVec4 kErrorColor{1.0f, 0.45f, 0.40f, 1}, kChangedColor{1.0f, 0.80f, 0.35f, 1},
    kDimColor{0.55f, 0.57f, 0.60f, 1};

}  // namespace tyndall::editor
