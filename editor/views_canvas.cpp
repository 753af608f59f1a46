#include "views_canvas.hpp"

#include <cmath>

namespace tyndall::editor {
namespace {

constexpr float kZoomANotch = 1.25f;
constexpr float kClickPoints = 3;     // a press that moves less is a click
constexpr float kGridFromScale = 12;  // points per texel from which texels have borders

void drawGrid(const ViewCanvas::Seen& seen, glm::uvec2 image) {
  const float scale = seen.transform->scale();
  if (scale < kGridFromScale) return;
  const glm::vec2 first = glm::max(glm::floor(seen.transform->texelAt({0, 0})), glm::vec2(0));
  const glm::vec2 last = glm::min(glm::ceil(seen.transform->texelAt(seen.size)), glm::vec2(image));
  const ImU32 colour = IM_COL32(128, 128, 128, 60);
  for (float x = first.x; x <= last.x; x += 1)
    seen.list->AddLine(toIm(seen.pointOf({x, first.y})), toIm(seen.pointOf({x, last.y})), colour);
  for (float y = first.y; y <= last.y; y += 1)
    seen.list->AddLine(toIm(seen.pointOf({first.x, y})), toIm(seen.pointOf({last.x, y})), colour);
}

}  // namespace

void ViewCanvas::buttons(Workspace& workspace, const std::string& name) {
  if (ImGui::SmallButton("fit")) wanted_ = Wanted::kFit;
  workspace.place(name + " fit");
  ImGui::SameLine();
  if (ImGui::SmallButton("1:1")) wanted_ = Wanted::kOneToOne;
  workspace.place(name + " 1:1");
}

ViewCanvas::Seen ViewCanvas::begin(Workspace& workspace, const std::string& name, ImVec2 size, glm::uvec2 image,
                                   const ViewTexture& texture) {
  Seen seen;
  seen.low = toGlm(ImGui::GetCursorScreenPos());
  seen.size = glm::max(toGlm(size), glm::vec2(8));
  seen.transform = &transform_;
  ImGui::InvisibleButton("canvas", toIm(seen.size));
  workspace.place(name + " canvas");
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  const ImGuiIO& io = ImGui::GetIO();
  if (image != image_ && image.x > 0) image_ = image, wanted_ = Wanted::kFit;
  if (image.x > 0 && wanted_ != Wanted::kNothing) {
    if (wanted_ == Wanted::kFit)
      transform_.fit(glm::vec2(image), seen.size);
    else
      transform_.oneToOne(glm::vec2(image), seen.size);
    wanted_ = Wanted::kNothing;
  }
  const glm::vec2 mouse = toGlm(io.MousePos) - seen.low;
  if (hovered && io.MouseWheel != 0) transform_.zoomAbout(mouse, std::pow(kZoomANotch, io.MouseWheel));
  if (ImGui::IsItemActivated())
    dragged_ = 0;
  else if (active && !dragTaken) {
    dragged_ += std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y);
    if (dragged_ > kClickPoints) transform_.pan(toGlm(io.MouseDelta));
  }
  seen.clicked = ImGui::IsItemDeactivated() && hovered && dragged_ <= kClickPoints;
  if (hovered && image.x > 0) {
    const glm::vec2 texel = glm::floor(transform_.texelAt(mouse));
    if (texel.x >= 0 && texel.y >= 0 && texel.x < static_cast<float>(image.x) && texel.y < static_cast<float>(image.y))
      seen.hovered = glm::ivec2(texel);
  }
  seen.list = ImGui::GetWindowDrawList();
  seen.list->PushClipRect(toIm(seen.low), toIm(seen.low + seen.size), true);
  seen.list->AddRectFilled(toIm(seen.low), toIm(seen.low + seen.size), IM_COL32(18, 18, 20, 255));
  if (texture && image.x > 0) {
    seen.list->AddImage(texture.id(transform_.scale() >= 1), toIm(seen.pointOf({0, 0})),
                        toIm(seen.pointOf(glm::vec2(image))));
    drawGrid(seen, image);
  }
  char text[64];
  std::snprintf(text, sizeof text, "%.6g", static_cast<double>(transform_.scale()));
  workspace.facts[name + " scale"] = text;
  return seen;
}

}  // namespace tyndall::editor
