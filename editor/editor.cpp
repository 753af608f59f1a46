#include "editor.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/values.hpp"
#include "base/log.hpp"
#include "controls_panel.hpp"
#include "display_errors.hpp"
#include "drag_bar.hpp"
#include "help_panel.hpp"
#include "recovery.hpp"
#include "status_panel.hpp"

namespace tyndall::editor {
namespace {

constexpr double kHiddenSeconds = 0.25;  // how long a window sleeps that is nowhere to be seen
constexpr float kLeastSide = 200;        // width of the panels, points at normal text
constexpr float kMostSide = 0.8f;        // of the window's width
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void beginFixed(const char* name, float x, float y, float width, float height, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({std::max(width, 1.0f), std::max(height, 1.0f)});
  ImGui::Begin(name, nullptr, kFixed | more);
}

void chooseStyle(float textScale) {
  ImGui::GetStyle() = {};
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0, style.FrameRounding = 2, style.WindowBorderSize = 0;
  style.WindowPadding = {8, 6}, style.FramePadding = {4, 2}, style.ItemSpacing = {6, 3}, style.CellPadding = {3, 1};
  style.Colors[ImGuiCol_WindowBg] = {0.10f, 0.105f, 0.115f, 1};
  style.ScaleAllSizes(textScale);
}

}  // namespace

ImGuiContextOwner::ImGuiContextOwner() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // what is kept is in the settings' file
  chooseStyle(1);
}

ImGuiContextOwner::~ImGuiContextOwner() { ImGui::DestroyContext(); }

Result<std::unique_ptr<Editor>> Editor::open(const Options& options) {
  std::unique_ptr<Editor> editor(new Editor(options));
  auto path = app::findLevel(options.level);
  if (!path) return path.error();
  editor->outputs_.protect(*path);
  if (!options.preset.empty()) editor->outputs_.protect(options.preset);
  if (!options.screenshot.empty())
    if (auto added = editor->outputs_.add("--screenshot", options.screenshot, ".png"); !added) return added.error();
  if (!options.state.empty())
    if (auto added = editor->outputs_.add("--print-state", options.state, ".json"); !added) return added.error();
  auto catalogue = loadCatalogue(options);
  if (!catalogue) return catalogue.error();
  auto level = app::loadLevel(options.level);
  if (!level) return level.error();
  if (auto camera = app::chooseCamera(*level, options.camera, options.seconds); !camera) return camera.error();
  std::vector<std::string> told = (*catalogue)->warnings();
  told.insert(told.end(), level->warnings.begin(), level->warnings.end());
  told.insert(told.end(), level->notes.begin(), level->notes.end());

  // A window larger than any image a device is sure to take is a slip of the finger; the device's limit is looked at
  // below.
  if (auto fits = app::checkSize("--size", options.size, 16384, "a window takes"); !fits) return fits.error();
  auto window = Window::open("Tyndall - " + level->name, options.size);
  if (!window) return window.error();
  editor->window_ = window.take();
  gpu::DeviceOptions device;
  device.name = options.device, device.validation = options.validate, device.window = true;
  auto extensions = editor->window_->instanceExtensions();
  if (!extensions) return extensions.error();
  device.instanceExtensions = extensions.take();
  auto session = app::Session::open(catalogue.take(), device);
  if (!session) return session.error();
  editor->session_ = session.take();
  editor->session_->buildInBackground(true);
  if (auto fits = app::checkSize("--size", options.size, editor->session_->maxSide(),
                                 editor->session_->device().info().name + " takes");
      !fits)
    return fits.error();
  const scene::Bounds bounds = scene::worldBounds(level->scene, level->worldFromNode(options.seconds));
  editor->camera_.emplace(bounds.empty() ? 10.0f : glm::length(bounds.max - bounds.min));
  if (auto set = editor->session_->setLevel(level.take()); !set) return set.error();
  editor->noticeLevel();
  auto swapchain = Swapchain::create(editor->session_->device(), *editor->window_);
  if (!swapchain) return swapchain.error();
  editor->swapchain_ = swapchain.take();
  editor->imgui_ = std::make_unique<ImGuiContextOwner>();
  editor->input_ = std::make_unique<Input>(*editor->window_);
  auto renderer = ImGuiRenderer::create(editor->session_->device(), editor->swapchain_->format());
  if (!renderer) return renderer.error();
  editor->renderer_ = renderer.take();
  editor->windowMemory_ = std::make_unique<render::GraphMemory>(editor->session_->device());
  const auto wake = [woken = &editor->woken_] { *woken = true, glfwPostEmptyEvent(); };
  editor->research_ = std::make_unique<Research>(*editor->session_, *editor->renderer_,
                                                 Laboratory::Options{device, options.pluginFolder, wake});
  editor->workspace_.seconds = options.seconds;
  for (const std::string& line : told) editor->workspace_.tell(line, false);
  std::string problem;
  editor->settings_ = editor->settingsFile_.read(problem);
  if (const auto folder = editor->settingsFile_.folder(); !folder.empty())
    if (const std::string note = recoveryNote(folder); !note.empty()) {
      log::warning(note);
      editor->workspace_.tell(note, false);
    }
  if (!problem.empty()) editor->workspace_.tell(problem, true);
  editor->settings_.opened(editor->levelText());
  editor->capture_.restore(editor->settings_);
  // A hand's events are taken, and other programs answered, also while a picture is waited for.
  editor->session_->device().whileWaiting([window = editor->window_.get()] { window->poll(); });
  outliveDisplayErrors();
  onDisplayLost([it = editor.get()] {
    std::fprintf(stderr, "tyndall-editor: the display is gone%s\n", it->keepEdits().c_str());
    std::_Exit(1);  // whatever is left to tidy up would ask for the display
  });
  return editor;
}

Editor::~Editor() { onDisplayLost(nullptr); }

Result<void> Editor::run() {
  auto done = loop();
  if (done || stress_) return done;
  return Error{done.error().message + keepEdits(), done.error().kind};
}

Result<void> Editor::loop() {
  if (options_.stress > 0) stress_ = std::make_unique<Stress>(options_.stress, options_.seed);
  while (!window_->closing()) {
    if (stress_) {
      auto going = stress_->act({*session_, workspace_, *window_, pictures_});
      if (!going) return going.error();
      if (!*going) break;
    }
    awaitEvents();
    if (!drawDue()) continue;
    auto drawn = step();
    if (!drawn) return drawn.error();
    if (!*drawn) window_->wait(kHiddenSeconds);
    if (options_.frames > 0 && frames_ >= options_.frames) break;
  }
  if (auto finished = session_->finishFrames(); !finished) return finished;
  if (stress_)
    if (auto good = stress_->report({*session_, workspace_, *window_, pictures_}); !good) return good;
  const std::uint32_t messages = session_->device().validationMessages() + research_->validationMessages();
  if (messages > 0)
    return failed("--validate: the validation layer gave " + std::to_string(messages) +
                  " messages (above); none is right");
  return writeScreenshot();
}

Result<bool> Editor::step() {
  auto fits = swapchain_->fit(window_->pixels());
  if (!fits || !*fits) return fits;
  times_.take(*session_);
  // Whatever has happened since the last picture is seen by the interface in its order, whatever the picture took.
  while (input_->pending())
    if (auto done = interface(); !done) return done.error();
  if (auto done = interface(); !done) return done.error();
  redrawAt_ = glfwGetTime() + workspace_.redrawIn;

  const bool wanted = pictureWanted();
  if (!wanted) stillTime_ = glfwGetTime();
  if (wanted) {
    if (auto rendered = renderPicture(); !rendered) {
      if (!picture_) return rendered.error();  // there is nothing to go on with
      workspace_.tell(rendered.error().message, true);
    }
  } else if (!timesTaken_) {
    // Nothing to do but wait: the panel then shows the times of the picture that is seen.
    if (auto finished = session_->finishFrames(); !finished) return finished.error();
    timesTaken_ = true;
  }
  if (auto shown = renderWindow(); !shown) return shown.error();
  ++frames_;
  toDraw_ = wanted ? std::max(toDraw_, 2u) - 1 : std::max(toDraw_, 1u) - 1;
  // Whether the window shows what the settings say: scripts wait for it.
  const bool building = session_->background() == host::PluginEffect::Background::kBuilding;
  workspace_.facts["picture"] = building ? "building" : pictureWanted() ? "due" : "current";
  const StateFile::Snapshot now{*session_,     workspace_, *camera_, history_, camera_->view(fileCamera()),
                                cameraIndex(), frames_,    pictures_};
  if (auto written = state_.update(now); !written) return written.error();
  return true;
}

Result<void> Editor::interface() {
  noticeLevel();
  if (auto done = scaleText(); !done) return done.error();
  input_->beginFrame(glfwGetTime());
  ImGui::NewFrame();
  workspace_.widgets.clear();
  workspace_.facts.clear();
  workspace_.redrawIn = kNever;
  drawWindows();
  steer();
  watchEdits();
  ImGui::Render();
  if (std::exchange(captureAsked_, false)) takeCapture();
  writeView();
  if (!levelAsked_.empty()) openLevel(std::exchange(levelAsked_, ""));
  if (levelLost_) return *levelLost_;
  keepSettings();
  return {};
}

Result<void> Editor::scaleText() {
  const float wanted = settings_.layout.textScale > 0 ? settings_.layout.textScale : window_->textScale();
  if (wanted == textScale_) return {};
  textScale_ = wanted;
  chooseStyle(wanted);
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  ImFontConfig font;
  font.SizePixels = std::round(kTextHeight * wanted);
  fonts.AddFontDefault(&font);
  return renderer_->makeFont();
}

std::uint32_t Editor::cameraIndex() const {
  return std::min(options_.camera,
                  static_cast<std::uint32_t>(session_->level()->cameras(workspace_.seconds).size()) - 1);
}

scene::CameraView Editor::fileCamera() const { return session_->level()->cameras(workspace_.seconds)[cameraIndex()]; }

Research::Viewport Editor::viewport() const {
  return {camera_->view(fileCamera()),  viewWidth_, viewHeight_, viewLow_, viewSize_, viewHovered_,
          moving_ || workspace_.playing};
}

void Editor::drawWindows() {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const float status = ImGui::GetFrameHeight() + 6;
  const MenuChoice choice = menu_.draw(history_, settings_, workspace_);
  if (!choice.level.empty()) levelAsked_ = choice.level;
  for (const Command command : choice.commands) perform(command);
  const float top = menu_.height(), height = size.y - status - top;
  // Whole points, so that the picture is not stretched by part of one.
  const float automatic = std::min(std::clamp(size.x * 0.32f, scaled(290), scaled(420)), size.x / 2);
  const float side = Layout::sizeOf(settings_.layout.side, automatic, scaled(kLeastSide), size.x * kMostSide);
  dividing_ = false;
  drawViewport(top, settings_.layout.panels ? size.x - side : size.x, height);
  if (settings_.layout.panels) drawSide(size.x - side, top, side, height);
  if (const auto step = drawHistory(history_, historyOpen_, workspace_)) restore(history_.jump(*step));
  drawHelp(helpOpen_, workspace_);
  research_->draw(workspace_, viewport());
  if (const auto file = files_.draw(workspace_)) fileChosen(*file);
  drawComparison();
  if (capture_.draw(workspace_)) captureAsked_ = true;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(8, 5));
  beginFixed("status", 0, size.y - status, size.x, status, ImGuiWindowFlags_NoScrollWithMouse);
  drawStatus(*session_, workspace_, viewWidth_, viewHeight_);
  ImGui::End();
  ImGui::PopStyleVar();
}

void Editor::drawViewport(float y, float width, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  beginFixed("viewport", 0, y, width, height, ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBackground);
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  const std::uint32_t limit = session_->maxSide();
  viewWidth_ = std::clamp(static_cast<std::uint32_t>(std::max(width, 1.0f) * scale.x), 1u, limit);
  viewHeight_ = std::clamp(static_cast<std::uint32_t>(std::max(height, 1.0f) * scale.y), 1u, limit);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(
      "picture", {std::max(width, 1.0f), std::max(height, 1.0f)},
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  workspace_.place("viewport");
  viewHovered_ = ImGui::IsItemHovered();
  // Not in the frame of the press itself: the mouse's way to where it was pressed is no drag.
  const bool dragged = ImGui::IsItemActive() && !ImGui::IsItemActivated();
  looking_ = dragged && ImGui::IsMouseDown(ImGuiMouseButton_Right);
  const bool orbits = dragged && ImGui::IsMouseDown(ImGuiMouseButton_Middle) && !looking_;
  if (orbits && !orbiting_) orbitPivot_ = level_.pivot(*session_->level(), workspace_.seconds);
  orbiting_ = orbits;
  ImGui::GetWindowDrawList()->AddImage(reinterpret_cast<ImTextureID>(Texture::kPicture), low,
                                       {low.x + width, low.y + height});
  viewLow_ = {low.x, low.y}, viewSize_ = {width, height};
  research_->drawOver(*ImGui::GetWindowDrawList(), workspace_, viewport());
  level_.drawOver(*ImGui::GetWindowDrawList(), *session_,
                  {camera_->view(fileCamera()), viewLow_, viewSize_, viewHovered_}, workspace_);
  ImGui::End();
  ImGui::PopStyleVar();
}

void Editor::drawSide(float x, float y, float width, float height) {
  beginFixed("side", x, y, width, height, ImGuiWindowFlags_NoScrollWithMouse);
  // The bar is in the margin, left of everything else, where windows neither draw nor take the mouse.
  const ImVec2 content = ImGui::GetCursorPos();
  ImGui::PushClipRect({x, y}, {x + width, y + height}, false);
  ImGui::SetCursorPos({0, 0});
  dividing_ = dragBar("side edge", Edge::kLeft, width, scaled(kLeastSide), ImGui::GetIO().DisplaySize.x * kMostSide,
                      settings_.layout.side, workspace_);
  ImGui::PopClipRect();
  ImGui::SetCursorPos(content);
  drawControls(*session_, *camera_, workspace_);
  ImGui::Separator();
  const float room = ImGui::GetContentRegionAvail().y, least = scaled(40), most = std::max(room - least, least);
  const float figures =
      Layout::sizeOf(settings_.layout.figures, std::clamp(height * 0.42f, scaled(90), scaled(380)), least, most);
  ImGui::BeginChild("parameters", {0, std::max(room - figures, 1.0f)});
  parameters_.draw(*session_, workspace_);
  ImGui::EndChild();
  dragBar("figures edge", Edge::kTop, figures, least, most, settings_.layout.figures, workspace_);
  if (ImGui::BeginTabBar("figures")) {
    const auto tab = [this](const char* name) {
      const bool open = ImGui::BeginTabItem(name);
      workspace_.place(std::string("tab ") + name);
      return open;
    };
    if (tab("times")) times_.draw(settings_.budgetMs, workspace_), ImGui::EndTabItem();
    if (tab("memory")) memory_.draw(*session_, workspace_), ImGui::EndTabItem();
    if (tab("skipped")) MemoryPanel::drawSkipped(*session_, workspace_), ImGui::EndTabItem();
    if (tab("level")) {
      const auto seen = camera_->flown() ? std::nullopt : std::optional(cameraIndex());
      level_.draw(*session_, seen, settings_.layout.fields, workspace_);
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  ImGui::End();
}

}  // namespace tyndall::editor
