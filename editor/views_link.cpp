#include "views_link.hpp"

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "views_canvas.hpp"
#include "views_project.hpp"

namespace tyndall::editor {
namespace {

using render::ViewRole;

constexpr ImU32 kHoverColour = IM_COL32(255, 205, 90, 255), kPinColour = IM_COL32(90, 200, 255, 255),
                kBlockedColour = IM_COL32(255, 95, 80, 255), kLitColour = IM_COL32(120, 220, 110, 255),
                kCurveColour = IM_COL32(200, 205, 215, 255);

constexpr ViewRole kRoles[] = {ViewRole::kRowPlace, ViewRole::kLightRayStart, ViewRole::kLightRayEnd,
                               ViewRole::kRowDepths};

/// Texel of an image at a share of it.
glm::uvec2 texelAt(const app::ViewPicture& picture, glm::vec2 share) {
  const glm::vec2 size(static_cast<float>(picture.width), static_cast<float>(picture.height));
  return glm::uvec2(glm::clamp(glm::floor(share * size), glm::vec2(0), size - 1.0f));
}

std::string text(const char* format, double a, double b, double c, double d, double e, double f) {
  char line[192];
  std::snprintf(line, sizeof line, format, a, b, c, d, e, f);
  return line;
}

}  // namespace

std::vector<app::ViewRequest> RowLink::requests(const ResearchContext& context) const {
  std::vector<app::ViewRequest> list;
  if (!open) return list;
  for (const ViewRole role : kRoles)
    if (const std::string name = context.viewOf(role); !name.empty()) list.push_back({name});
  for (const app::ViewRequest& request : walk_.requests(context, rows())) list.push_back(request);
  return list;
}

void RowLink::take(const ResearchContext& context, const std::vector<app::ViewPicture>& pictures, const Shot& shot) {
  const auto find = [&](ViewRole role, app::ViewPicture& target) {
    target = {};
    const std::string name = context.viewOf(role);
    for (const app::ViewPicture& picture : pictures)
      if (picture.name == name && picture.width > 0) target = picture;
  };
  find(ViewRole::kRowPlace, places_);
  find(ViewRole::kLightRayStart, starts_);
  find(ViewRole::kLightRayEnd, ends_);
  find(ViewRole::kRowDepths, depths_);
  walk_.take(context, pictures);
  shot_ = shot;
}

std::optional<LightRay> RowLink::rayAt(glm::vec2 share) const {
  if (starts_.values.empty() || ends_.values.empty()) return std::nullopt;
  const glm::uvec2 at = texelAt(starts_, share);
  if (starts_.at(at.x, at.y, 3) < 0.5f) return std::nullopt;
  const auto point = [&](const app::ViewPicture& p) {
    return glm::vec3(p.at(at.x, at.y, 0), p.at(at.x, at.y, 1), p.at(at.x, at.y, 2));
  };
  return LightRay{point(starts_), point(ends_), ends_.at(at.x, at.y, 3) > 0.5f};
}

void RowLink::update(ResearchContext& context) {
  place_.reset(), hoveredRay_.reset(), pinnedRay_.reset();
  auto& facts = context.workspace.facts;
  if (pixel_ && !places_.values.empty() && !stale(context)) {
    const glm::ivec2 p = *pixel_;
    if (p.x >= 0 && p.y >= 0 && p.x < static_cast<int>(places_.width) && p.y < static_cast<int>(places_.height)) {
      const auto value = [&](std::uint32_t c) {
        return places_.at(static_cast<std::uint32_t>(p.x), static_cast<std::uint32_t>(p.y), c);
      };
      place_ = RowPlace{{value(0), value(1)}, value(2), value(3)};
      hoveredRay_ = rayAt(place_->share);
      facts["link"] = text("%.0f %.0f %.9g %.9g %.9g %.9g", p.x, p.y, value(0), value(1), value(2), value(3));
    }
  }
  if (pinned_) pinnedRay_ = rayAt(*pinned_);
  if (pinnedRay_)
    facts["pinned ray"] = text("%.9g %.9g %.9g %.9g %.9g %.9g", pinnedRay_->start.x, pinnedRay_->start.y,
                               pinnedRay_->start.z, pinnedRay_->end.x, pinnedRay_->end.y, pinnedRay_->end.z);
}

void RowLink::drawMarks(ImDrawList& list, const std::function<ImVec2(glm::vec2)>& pointOf) const {
  const auto cross = [&](glm::vec2 share, ImU32 colour) {
    const ImVec2 p = pointOf(share);
    list.AddLine({p.x - 7, p.y}, {p.x + 7, p.y}, colour, 1.5f);
    list.AddLine({p.x, p.y - 7}, {p.x, p.y + 7}, colour, 1.5f);
  };
  const ImU32 faint = IM_COL32(255, 205, 90, 90);
  if (place_) {
    // Thin: the whole slice and the whole column; thick: the columns that the ray passes.
    list.AddLine(pointOf({place_->share.x, 0}), pointOf({place_->share.x, 1}), faint);
    list.AddLine(pointOf({0, place_->share.y}), pointOf({1, place_->share.y}), faint);
    list.AddLine(pointOf({place_->share.x, 0}), pointOf(place_->share), kHoverColour, 2.0f);
    cross(place_->share, kHoverColour);
  }
  if (pinned_) cross(*pinned_, kPinColour);
}

void RowLink::drawRays(const ResearchContext& context, ImDrawList& list, glm::vec2 low, glm::vec2 size) const {
  const render::View view = render::makeView(context.shot.camera, context.shot.width, context.shot.height);
  const glm::mat4 clipFromWorld = view.clipFromView * view.viewFromWorld;
  list.PushClipRect(toIm(low), toIm(low + size), true);
  const auto draw = [&](const LightRay& ray, ImU32 colour, float width) {
    const auto seen = projectSegment(clipFromWorld, ray.start, ray.end, size);
    if (!seen) return;
    const auto [from, to] = *seen;
    // Dark below, so that it is seen on every picture.
    list.AddLine(toIm(low + from), toIm(low + to), IM_COL32(0, 0, 0, 160), width + 2);
    list.AddLine(toIm(low + from), toIm(low + to), colour, width);
    if (ray.blocked)
      list.AddCircleFilled(toIm(low + to), 4.5f, kBlockedColour);
    else
      list.AddCircle(toIm(low + to), 4, colour);
  };
  if (hoveredRay_ && open) draw(*hoveredRay_, kHoverColour, 1.0f);
  if (pinnedRay_ && open) draw(*pinnedRay_, kPinColour, 2.0f);
  list.PopClipRect();
}

void RowLink::draw(ResearchContext& context) {
  if (!open) return;
  ImGui::SetNextWindowSize({scaled(520), scaled(235)}, ImGuiCond_FirstUseEver);
  // Low in the corner, where it hides little of the picture.
  ImGui::SetNextWindowPos({6, std::max(ImGui::GetIO().DisplaySize.y - 270, 60.0f)}, ImGuiCond_FirstUseEver);
  if (ImGui::Begin("Row of a pixel", &open, ImGuiWindowFlags_NoFocusOnAppearing)) {
    if (context.viewOf(ViewRole::kRowPlace).empty())
      ImGui::TextUnformatted("The technique in use works on no rows.");
    else if (places_.values.empty())
      ImGui::TextUnformatted("Waiting for the maps ...");
    else if (stale(context))
      ImGui::TextColored(kDimColor, "the view has changed; the maps follow");
    else if (place_) {
      const glm::uvec2 at = texelAt(depths_.values.empty() ? places_ : depths_, place_->share);
      ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kHoverColour),
                         "pixel %d %d   slice %u   column %u   inclination %.3f deg   depth %.5f", pixel_->x, pixel_->y,
                         at.x, at.y, static_cast<double>(place_->inclination) * 180 / std::numbers::pi,
                         static_cast<double>(place_->depth));
    } else
      ImGui::TextColored(kDimColor, "point at the picture to see where its ray lies in the maps");
    if (pinnedRay_)
      ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kPinColour), "pinned light ray %s at (%.3f, %.3f, %.3f)",
                         pinnedRay_->blocked ? "is blocked" : "leaves the view", static_cast<double>(pinnedRay_->end.x),
                         static_cast<double>(pinnedRay_->end.y), static_cast<double>(pinnedRay_->end.z));
    else
      ImGui::TextColored(kDimColor, "click a texel of a map of rows to see its light ray in the picture");
    if (WalkView::offered(context)) {
      if (ImGui::SmallButton("walk in the map")) walk_.open = !walk_.open;
      context.workspace.place("walk");
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("How the technique finds what blocks the ray, level by level");
    }
    if (!depths_.values.empty()) drawProfile(std::max(ImGui::GetContentRegionAvail().y, 60.0f));
  }
  ImGui::End();
  std::optional<glm::vec3> end;
  if (place_ && !stale(context)) end = glm::vec3(place_->share, place_->depth);
  walk_.draw(context, rows(), end);
}

/// The depths of the first blockers along the row, and the ray's own depth over the columns that it passes: lit where
/// the blocker lies below (farther from the light).
void RowLink::drawProfile(float height) const {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 40.0f);
  ImGui::Dummy({width, height});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, IM_COL32(18, 18, 20, 255));
  const std::optional<glm::vec2> share = place_ ? std::optional(place_->share) : pinned_;
  if (!share) return;
  const std::uint32_t slice = texelAt(depths_, *share).x;
  const auto pointOf = [&](float column, float depth) {
    return ImVec2(low.x + column / static_cast<float>(depths_.height) * width,
                  low.y + 2 + std::clamp(depth, 0.0f, 1.0f) * (height - 4));
  };
  for (std::uint32_t column = 0; column < depths_.height; ++column) {
    const float depth = depths_.at(slice, column, 0), at = static_cast<float>(column);
    // What lies behind the blocker is dark.
    if (depth < 1) list.AddRectFilled(pointOf(at, depth), pointOf(at + 1, 1), IM_COL32(60, 62, 70, 255));
    list.AddLine(pointOf(at, depth), pointOf(at + 1, depth), kCurveColour);
  }
  if (!place_) return;
  const float end = place_->share.y * static_cast<float>(depths_.height);
  for (std::uint32_t column = 0; static_cast<float>(column) < end; ++column) {
    const float at = static_cast<float>(column);
    const bool lit = place_->depth <= depths_.at(slice, column, 0);
    list.AddLine(pointOf(at, place_->depth), pointOf(std::min(at + 1, end), place_->depth),
                 lit ? kLitColour : kBlockedColour, 2);
  }
  list.AddLine(pointOf(end, place_->depth), pointOf(static_cast<float>(depths_.height), place_->depth),
               IM_COL32(255, 205, 90, 70));
  list.AddCircleFilled(pointOf(end, place_->depth), 3.5f, kHoverColour);
}

}  // namespace tyndall::editor
