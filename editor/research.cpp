#include "research.hpp"

#include <algorithm>

namespace tyndall::editor {
namespace {

// How long the view must have been the same before background work starts: a flight or a drag on a slider is no wish
// for it.
constexpr double kSettleSeconds = 0.3;
constexpr double kProgressSeconds = 0.25;  // how often progress is shown

std::string textOf(const std::vector<app::ViewRequest>& requests) {
  std::string text;
  for (const app::ViewRequest& request : requests)
    text += request.name + " " + std::to_string(request.layer.value_or(~0u)) + " " +
            std::to_string(request.mip.value_or(~0u)) + "\n";
  return text;
}

}  // namespace

Laboratory* Research::laboratory(Workspace& workspace) {
  if (laboratory_ || laboratoryFailed_) return laboratory_.get();
  auto opened = Laboratory::open(options_);
  if (!opened) {
    laboratoryFailed_ = true;  // it would fail again every frame
    workspace.tell("background rendering: " + opened.error().message, true);
    return nullptr;
  }
  laboratory_ = opened.take();
  return laboratory_.get();
}

ResearchContext Research::context(Workspace& workspace, const Viewport& viewport) {
  const app::Level& level = *session_.level();
  if (!level_ || levelEdits_ != workspace.levelEdits || levelPath_ != level.path.string()) {
    level_ = std::make_shared<const app::Level>(level);
    levelEdits_ = workspace.levelEdits;
    levelPath_ = level.path.string();
  }
  ResearchContext context{session_, workspace, renderer_, {}, false, {}, {}};
  context.shot.level = level_;
  context.shot.camera = viewport.camera;
  context.shot.seconds = workspace.seconds;
  context.shot.width = viewport.width, context.shot.height = viewport.height;
  for (const params::Parameter& parameter : session_.table().parameters())
    context.shot.values[parameter.id] = session_.table().value(parameter.id);
  const double now = ImGui::GetTime();
  if (!(context.shot == lastShot_)) lastShot_ = context.shot, changedAt_ = now;
  const double still = now - changedAt_;
  context.settled = !viewport.moving && still >= kSettleSeconds;
  if (!viewport.moving && !context.settled) workspace.drawAgain(kSettleSeconds - still);
  for (const render::DebugViewInfo& view : session_.debugViews()) context.roles[view.name] = view.role;
  context.laboratory = [this, &workspace] { return laboratory(workspace); };
  return context;
}

void Research::drawOver(ImDrawList& list, Workspace& workspace, const Viewport& viewport) {
  if (!link_.open) return;
  const ResearchContext now = context(workspace, viewport);
  link_.drawRays(now, list, viewport.low, viewport.size);
}

void Research::draw(Workspace& workspace, const Viewport& viewport) {
  if (laboratory_) laboratory_->poll();
  ResearchContext now = context(workspace, viewport);
  bar(now, viewport);
  std::optional<glm::ivec2> pixel;
  if (viewport.hovered) {
    const glm::vec2 mouse = (toGlm(ImGui::GetIO().MousePos) - viewport.low) / viewport.size;
    pixel = glm::ivec2(
        glm::floor(mouse * glm::vec2(static_cast<float>(viewport.width), static_cast<float>(viewport.height))));
  }
  link_.hover(pixel);
  // Windows may point at pixels too; what they show of the link is then a frame old.
  for (auto& window : windows_)
    if (!window->draw(now, link_, viewsJob_)) window.reset();
  std::erase(windows_, nullptr);
  link_.update(now);
  link_.draw(now);
  updateViews(now);
  truth_.draw(now);
  plot_.draw(now, truth_.reference);
}

void Research::bar(ResearchContext& context, const Viewport& viewport) {
  ImGui::SetNextWindowPos({viewport.low.x + 6, viewport.low.y + 6});
  ImGui::SetNextWindowBgAlpha(0.75f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(4, 3));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::Begin("research bar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  if (ImGui::Button("views ...")) ImGui::OpenPopup("view menu");
  context.workspace.place("views");
  viewMenu(context);
  const auto toggle = [&](const char* label, bool& open, const char* help) {
    ImGui::SameLine();
    const bool on = open;
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(label)) open = !open;
    if (on) ImGui::PopStyleColor();
    context.workspace.place(label);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  };
  toggle("rows", link_.open, "Where a pixel's ray lies in the rectified maps, and back");
  toggle("reference", truth_.open, "Compares with ray-traced truth, a dense march, or a stored picture");
  toggle("plot", plot_.open, "Error against time of every technique");
  if (busy()) {
    ImGui::SameLine();
    ImGui::TextColored(kChangedColor, "working");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Something is rendered beside the window");
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  if (busy()) context.workspace.drawAgain(kProgressSeconds);
  context.workspace.facts["background"] = busy() ? "busy" : "idle";
}

void Research::viewMenu(ResearchContext& context) {
  ImGui::SetNextWindowSizeConstraints({220, 0}, {600, 560});
  if (!ImGui::BeginPopup("view menu")) return;
  std::size_t left = render::Renderer::debugViews().size();
  ImGui::TextColored(kDimColor, "engine");
  for (const render::DebugViewInfo& view : session_.debugViews()) {
    if (left-- == 0) ImGui::TextColored(kDimColor, "%s", session_.catalogue().effectPlugin().name().c_str());
    if (ImGui::Selectable(view.name.c_str())) windows_.push_back(std::make_unique<ViewWindow>(view.name, opened_++));
    context.workspace.place("open view " + view.name);
    if (ImGui::IsItemHovered() && !view.doc.empty()) ImGui::SetTooltip("%s", view.doc.c_str());
  }
  ImGui::EndPopup();
}

/// One frame in the background brings the numbers of all windows and of the link.
void Research::updateViews(ResearchContext& context) {
  std::vector<app::ViewRequest> requests;
  for (const auto& window : windows_) requests.push_back(window->request());
  const std::size_t ofWindows = requests.size();
  for (const app::ViewRequest& request : link_.requests(context)) requests.push_back(request);
  if (requests.empty()) {
    viewsWanted_.clear();
    if (viewsJob_) viewsJob_->cancel();
    return;
  }
  const std::string wanted = textOf(requests);
  if (viewsShot_ == context.shot && viewsWanted_ == wanted) return;
  if (running(viewsJob_) && !(viewsShot_ == context.shot)) viewsJob_->cancel();
  if (!context.settled || running(viewsJob_)) return;
  Laboratory* laboratory = context.laboratory();
  if (!laboratory) return;
  viewsShot_ = context.shot;
  viewsWanted_ = wanted;
  Workspace* workspace = &context.workspace;
  viewsJob_ = laboratory->render(
      "views", {context.shot, requests, false, 0},
      [this, workspace, requests, ofWindows, shot = context.shot](Result<RenderResult> result) {
        if (!result) return workspace->tell("views: " + result.error().message, true);
        std::vector<app::ViewPicture>& views = result->views;
        ResearchContext roles{session_, *workspace, renderer_, {}, false, {}, {}};
        for (const render::DebugViewInfo& view : session_.debugViews()) roles.roles[view.name] = view.role;
        link_.take(roles, {views.begin() + static_cast<std::ptrdiff_t>(std::min(ofWindows, views.size())), views.end()},
                   shot);
        for (std::size_t i = 0; i < std::min(ofWindows, views.size()); ++i)
          for (const auto& window : windows_)
            if (window->request() == requests[i]) window->take(views[i], shot);
      });
}

}  // namespace tyndall::editor
