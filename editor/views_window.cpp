#include "views_window.hpp"

#include <algorithm>
#include <cstdio>

namespace tyndall::editor {
namespace {

// Outliers must not take the whole range: what "auto" leaves out at each end.
constexpr double kAutoShare = 0.01;
constexpr const char* kChannels[] = {"R", "G", "B", "A", "RGB"};

}  // namespace

void ViewWindow::take(app::ViewPicture picture, const Shot& shot) {
  const bool first = picture_.values.empty();
  const bool otherChannels = picture.channels != picture_.channels;
  picture_ = std::move(picture);
  shot_ = shot;
  mapped_ = false;
  if (first)
    showOwnRange();
  else if (otherChannels && stretch_.channel < 4)
    stretch_.channel = std::min(stretch_.channel, std::max(picture_.channels, 1u) - 1);
}

void ViewWindow::showOwnRange() {
  stretch_.channel = picture_.shown < 4 ? std::min(picture_.shown, std::max(picture_.channels, 1u) - 1) : 4;
  stretch_.low = picture_.low, stretch_.high = picture_.high;
  mapped_ = false;
}

bool ViewWindow::draw(ResearchContext& context, RowLink& link, const JobPointer& job) {
  bool open = true;
  const std::string name = "view " + view_;
  const float offset = 28.0f * static_cast<float>(number_ % 8);
  ImGui::SetNextWindowPos({60 + offset, 60 + offset}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({scaled(470), scaled(400)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({240, 160}, {16384, 16384});
  const bool visible = ImGui::Begin((view_ + "##" + std::to_string(number_)).c_str(), &open,
                                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (visible) {
    toolbar(context.workspace);
    const float readOutHeight = ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (!mapped_ && !picture_.values.empty()) {
      const auto bytes = stretched(picture_.values, picture_.channels, stretch_);
      if (auto shown = texture_.set(context.renderer, picture_.width, picture_.height, bytes); !shown)
        context.workspace.tell(shown.error().message, true);
      mapped_ = true;
    }
    const auto seen = canvas_.begin(context.workspace, name, {room.x, std::max(room.y - readOutHeight, 20.0f)},
                                    {picture_.width, picture_.height}, texture_);
    const glm::vec2 size(static_cast<float>(picture_.width), static_cast<float>(picture_.height));
    const auto role = context.roles.find(view_);
    const bool rows = role != context.roles.end() && role->second >= render::ViewRole::kRows &&
                      role->second != render::ViewRole::kRowPlace && role->second <= render::ViewRole::kLightRayEnd;
    std::optional<glm::ivec2> linked;
    if (rows) {
      link.drawMarks(*seen.list, [&](glm::vec2 share) { return toIm(seen.pointOf(share * size)); });
      if (seen.clicked && seen.hovered) link.open = true, link.pin((glm::vec2(*seen.hovered) + 0.5f) / size);
      if (link.place() && picture_.width > 0)
        linked = glm::ivec2(glm::clamp(glm::floor(link.place()->share * size), glm::vec2(0), size - 1.0f));
    } else if (picture_.width == context.shot.width && picture_.height == context.shot.height) {
      // An image of the picture's pixels points at them as the picture does, and shows which one is pointed at.
      if (seen.hovered)
        link.hover(seen.hovered);
      else if (link.pixel() && link.open)
        linked = glm::clamp(*link.pixel(), glm::ivec2(0), glm::ivec2(size) - 1);
      if (linked) {
        const glm::vec2 at = seen.pointOf(glm::vec2(*linked) + 0.5f);
        seen.list->AddCircle(toIm(at), 6, IM_COL32(0, 0, 0, 200), 0, 3);
        seen.list->AddCircle(toIm(at), 6, IM_COL32(255, 205, 90, 255), 0, 1.5f);
      }
    }
    if (picture_.values.empty()) {
      const char* state = running(job) ? "rendering ..." : "the technique in use has no such view now";
      seen.list->AddText(toIm(seen.low + 8.0f), ImGui::GetColorU32(kDimColor), state);
    } else if (!(shot_ == context.shot)) {
      seen.list->AddText(toIm(seen.low + 6.0f), ImGui::GetColorU32(kChangedColor),
                         running(job) ? "updating ..." : "of an earlier view");
    }
    canvas_.end(seen);
    readOut(context, seen.hovered ? seen.hovered : linked, !seen.hovered && linked);
    char text[64];
    std::snprintf(text, sizeof text, "%u %u %u %s", picture_.width, picture_.height, picture_.channels,
                  shot_ == context.shot ? "current" : "stale");
    context.workspace.facts[name] = text;
  }
  ImGui::End();
  return open;
}

void ViewWindow::toolbar(Workspace& workspace) {
  ImGui::SetNextItemWidth(scaled(58));
  if (ImGui::BeginCombo("##channel", kChannels[stretch_.channel])) {
    for (std::uint32_t c = 0; c < 5; ++c)
      if ((c < picture_.channels || (c == 4 && picture_.channels >= 3)) &&
          ImGui::Selectable(kChannels[c], c == stretch_.channel))
        stretch_.channel = c, mapped_ = false;
    ImGui::EndCombo();
  }
  workspace.place("view " + view_ + " channel");
  ImGui::SameLine();
  ImGui::BeginDisabled(stretch_.channel == 4);
  if (ImGui::Checkbox("colours", &stretch_.falseColour)) mapped_ = false;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("False colours (viridis) instead of grey");
  workspace.place("view " + view_ + " colours");
  ImGui::EndDisabled();
  ImGui::SameLine();
  rangeFields(workspace);
  ImGui::SameLine();
  canvas_.buttons(workspace, "view " + view_);
  ImGui::SameLine(0, 2);
  if (ImGui::SmallButton("EXR") && !picture_.values.empty()) {
    workspace.writeViewName = view_;
    workspace.writeView = [exr = app::exrOf(picture_)](const std::filesystem::path& path) {
      return image::writeExr(path, exr);
    };
  }
  workspace.place("view " + view_ + " exr");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Writes the numbers of this layer and mip into the captures' folder");
  partChoice(workspace);
}

void ViewWindow::rangeFields(Workspace& workspace) {
  const float step = std::max((stretch_.high - stretch_.low) * 0.005f, 1e-9f);
  float low = stretch_.low, high = stretch_.high;
  ImGui::SetNextItemWidth(scaled(64));
  bool changed = ImGui::DragFloat("##low", &low, step, 0, 0, "%.4g");
  workspace.place("view " + view_ + " low");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Shown as black; drag, or Ctrl+click to type");
  ImGui::SameLine(0, 2);
  ImGui::SetNextItemWidth(scaled(64));
  changed |= ImGui::DragFloat("##high", &high, step, 0, 0, "%.4g");
  workspace.place("view " + view_ + " high");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Shown as white; drag, or Ctrl+click to type");
  // Equal ends stretch nothing; the last range stays until they differ.
  if (changed && low != high) stretch_.low = low, stretch_.high = high, mapped_ = false;
  ImGui::SameLine(0, 2);
  if (ImGui::SmallButton("auto") && !picture_.values.empty()) {
    const Range range = percentiles(picture_.values, picture_.channels, stretch_.channel, kAutoShare, 1 - kAutoShare);
    stretch_.low = range.low, stretch_.high = range.high, mapped_ = false;
  }
  workspace.place("view " + view_ + " auto");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("From the 1st to the 99th percentile");
  ImGui::SameLine(0, 2);
  if (ImGui::SmallButton("own") && !picture_.values.empty()) showOwnRange();
  workspace.place("view " + view_ + " own");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Channel and range that the view itself has");
}

void ViewWindow::partChoice(Workspace& workspace) {
  const auto choice = [&](const char* label, std::uint32_t now, std::uint32_t count,
                          std::optional<std::uint32_t>& wanted) {
    if (count < 2) return;
    int value = static_cast<int>(wanted.value_or(now));
    ImGui::SetNextItemWidth(scaled(110));
    if (ImGui::SliderInt(label, &value, 0, static_cast<int>(count) - 1))
      wanted = static_cast<std::uint32_t>(std::clamp(value, 0, static_cast<int>(count) - 1));
    workspace.place("view " + view_ + " " + label);
    ImGui::SameLine();
  };
  if (picture_.layers < 2 && picture_.mips < 2) return;
  choice("layer", picture_.layer, picture_.layers, layer_);
  choice("mip", picture_.mip, picture_.mips, mip_);
  ImGui::NewLine();
}

void ViewWindow::readOut(ResearchContext& context, const std::optional<glm::ivec2>& texel, bool linked) {
  const std::string name = "view " + view_ + " value";
  if (!texel || picture_.values.empty()) {
    if (picture_.values.empty())
      ImGui::TextUnformatted("");
    else
      ImGui::TextColored(kDimColor, "%u x %u  %s", picture_.width, picture_.height, picture_.format.c_str());
    return;
  }
  std::string line, fact = std::to_string(texel->x) + " " + std::to_string(texel->y);
  for (std::uint32_t c = 0; c < picture_.channels; ++c) {
    const float value = picture_.at(static_cast<std::uint32_t>(texel->x), static_cast<std::uint32_t>(texel->y), c);
    char number[48];
    std::snprintf(number, sizeof number, "  %s %.6g", picture_.channels == 1 ? "" : kChannels[c],
                  static_cast<double>(value));
    line += number;
    std::snprintf(number, sizeof number, " %.9g", static_cast<double>(value));
    fact += number;
  }
  context.workspace.facts[name] = fact;
  if (linked)
    ImGui::TextColored(kChangedColor, "linked %d %d%s", texel->x, texel->y, line.c_str());
  else
    ImGui::Text("%d %d%s", texel->x, texel->y, line.c_str());
}

}  // namespace tyndall::editor
