// The editor: one window, one session. Picture and window are drawn as two frames of the device: the picture only when
// it is out of date, the window whenever something happens.
#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <optional>

#include "app/outputs.hpp"
#include "app/session.hpp"
#include "capture_panel.hpp"
#include "file_browser.hpp"
#include "fly_camera.hpp"
#include "history.hpp"
#include "imgui_renderer.hpp"
#include "input.hpp"
#include "level_panel.hpp"
#include "memory_panel.hpp"
#include "menu_bar.hpp"
#include "options.hpp"
#include "parameter_panel.hpp"
#include "presets.hpp"
#include "research.hpp"
#include "settings_file.hpp"
#include "shortcuts.hpp"
#include "state_file.hpp"
#include "stress.hpp"
#include "swapchain.hpp"
#include "times_panel.hpp"
#include "watcher.hpp"
#include "window.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

/// Dear ImGui's context.
class ImGuiContextOwner {
 public:
  ImGuiContextOwner();
  ~ImGuiContextOwner();
  ImGuiContextOwner(const ImGuiContextOwner&) = delete;
  ImGuiContextOwner& operator=(const ImGuiContextOwner&) = delete;
};

inline constexpr double kNever = std::numeric_limits<double>::infinity();
/// After something has happened: windows that fit themselves to their content take two, and the times come in the next.
inline constexpr unsigned kSettledFrames = 3;

class Editor {
 public:
  /// Opens everything. Bad calls are found before the window is.
  static Result<std::unique_ptr<Editor>> open(const Options& options);
  ~Editor();
  /// Until the window is closed or the frames asked for are shown; then writes what was asked for.
  Result<void> run();

 private:
  explicit Editor(const Options& options);

  // editor.cpp: what is in the window
  Result<void> loop();
  Result<bool> step();       ///< false: there was nothing to draw on
  Result<void> interface();  ///< one frame of Dear ImGui, with one step of the input
  void drawWindows();
  void drawViewport(float y, float width, float height);
  void drawSide(float x, float y, float width, float height);
  Result<void> scaleText();  ///< to what is chosen, where it is not
  std::uint32_t cameraIndex() const;
  scene::CameraView fileCamera() const;
  Research::Viewport viewport() const;

  // editor_input.cpp: what the hands do
  void steer();
  void closeTop();     ///< what Esc does
  void awaitEvents();  ///< sleeps while drawDue() is false
  bool drawDue() const;

  // editor_commands.cpp: what the menu and the keys do
  void perform(Command command);
  void watchEdits();                     ///< what changed in this frame becomes a step of the history
  void restore(const EditState* state);  ///< null: nothing to undo or redo
  EditState editState() const;
  std::string levelText() const;  ///< the level as a sample's name or an absolute path
  void takeCapture();
  void writeView();    ///< what a viewer asked for
  void noticeLevel();  ///< what belongs to a level starts anew when it is another, whoever set it
  void openLevel(const std::string& level);
  void browse(Command command);  ///< opens the file window for it
  void fileChosen(const std::filesystem::path& file);
  void drawComparison();
  void keepSettings();
  std::string keepEdits() const;  ///< writes what would be lost; what to say of it, "" = nothing was

  // editor_frame.cpp: how it gets there
  Result<void> renderPicture();
  Result<void> renderWindow();
  Result<void> addScreenshot(render::Graph& graph, render::ImageRef window);
  Result<void> writeScreenshot();
  bool pictureWanted() const;

  Options options_;
  app::Outputs outputs_;
  // Destroyed from the last to the first: everything on the device before the session, the window at the very end.
  std::unique_ptr<Window> window_;
  std::unique_ptr<app::Session> session_;
  std::unique_ptr<ImGuiContextOwner> imgui_;
  std::unique_ptr<Input> input_;
  std::unique_ptr<Swapchain> swapchain_;
  std::unique_ptr<ImGuiRenderer> renderer_;
  std::unique_ptr<render::GraphMemory> windowMemory_;
  std::unique_ptr<Research> research_;
  gpu::Image picture_;      ///< the newest, as the window shows it
  gpu::Buffer screenshot_;  ///< the window drawn last
  VkExtent2D screenshotSize_{0, 0};

  std::optional<FlyCamera> camera_;
  ParameterPanel parameters_;
  TimesPanel times_;
  MemoryPanel memory_;
  LevelPanel level_;
  std::uint64_t levelsSeen_ = 0;
  SceneEdits editsSeen_;  ///< that levelEdits counts
  History history_;
  MenuBar menu_;
  CapturePanel capture_;
  bool captureAsked_ = false;
  std::optional<Error> levelLost_;  ///< neither a new level nor the one before could be set
  std::string levelAsked_;          ///< taken between two frames
  FileBrowser files_;
  Command filesFor_ = Command::kOpenLevel;
  std::filesystem::path compared_;  ///< a preset; "" = none
  SettingsFile settingsFile_;
  Settings settings_;
  bool historyOpen_ = false, helpOpen_ = false;
  float textScale_ = 1;    ///< of the font that is baked
  bool dividing_ = false;  ///< the bar beside the picture is dragged: its size waits until it is let go of
  Watcher watcher_;
  Workspace workspace_;
  std::unique_ptr<Stress> stress_;  ///< random use instead of a user's
  StateFile state_;
  std::uint32_t viewWidth_ = 0, viewHeight_ = 0;  ///< pixels of the viewport
  std::uint32_t frames_ = 0, pictures_ = 0;
  glm::vec2 viewLow_{0}, viewSize_{0};  ///< of the viewport on the screen, points
  bool viewHovered_ = false, looking_ = false, orbiting_ = false;
  glm::vec3 orbitPivot_{0};           ///< that the orbit under way goes round, world
  bool moving_ = false;               ///< the camera was flown in the last frame
  bool timesTaken_ = true;            ///< of the newest picture
  bool flying_ = false;               ///< a key that flies is down
  unsigned toDraw_ = kSettledFrames;  ///< frames until the window shows what has happened
  double redrawAt_ = kNever;          ///< when the window is drawn though nothing has happened, seconds since the start
  std::atomic<bool> woken_{false};    ///< something beside the window has finished
  host::PluginEffect::Background backgroundSeen_ = host::PluginEffect::Background::kIdle;
  double pictureTime_ = 0;      ///< of the newest picture
  double stillTime_ = 0;        ///< when no picture was wanted last: an eye that rests has adapted
  bool memoryReturned_ = true;  ///< since then
};

}  // namespace tyndall::editor
