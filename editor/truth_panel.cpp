#include "truth_panel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "views_colour.hpp"

namespace tyndall::editor {
namespace {

constexpr const char* kKinds[] = {"rays, traced on the CPU", "dense march on the GPU", "the stored picture"};
constexpr int kSampleChoices[] = {64, 256, 1024, 4096};
constexpr double kFlickerSeconds = 0.5;
constexpr float kBarWidth = 180, kBarHeight = 10;

}  // namespace

void TruthPanel::draw(ResearchContext& context) {
  if (!open) return;
  reference.update(context);
  // Right, so that viewers, which open left, do not hide it.
  ImGui::SetNextWindowPos({std::max(30.0f, static_cast<float>(context.shot.width) - 575), 40}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({scaled(560), scaled(520)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({320, 240}, {16384, 16384});
  if (ImGui::Begin("Reference", &open, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    controls(context);
    figures(context);
    ImGui::Separator();
    showChoice(context);
    picture(context);
  }
  ImGui::End();
  auto& facts = context.workspace.facts;
  facts["reference"] = reference.active() ? "running" : "idle";
  facts["reference made"] = reference.full(context) ? "full" : reference.valid(context) ? "coarse" : "none";
  facts["reference samples"] = std::to_string(reference.samples);
  if (const auto& metrics = reference.metrics()) {
    const ScatterPicture& truth = *reference.truth();
    char text[160];
    std::snprintf(text, sizeof text, "%u %u %.9g %.9g %.9g %.9g", truth.scatter.width, truth.scatter.height,
                  metrics->nRmse, metrics->p99, metrics->max, metrics->bias);
    facts["error"] = text;
  }
  if (!open) reference.cancel();
}

void TruthPanel::controls(ResearchContext& context) {
  Workspace& workspace = context.workspace;
  ImGui::SetNextItemWidth(scaled(190));
  if (ImGui::BeginCombo("##kind", kKinds[static_cast<int>(reference.kind)])) {
    for (int i = 0; i < 3; ++i) {
      const bool possible = i != static_cast<int>(ReferenceKind::kStored) || reference.hasStored();
      if (ImGui::Selectable(kKinds[i], i == static_cast<int>(reference.kind),
                            possible ? 0 : ImGuiSelectableFlags_Disabled))
        reference.kind = static_cast<ReferenceKind>(i);
      workspace.place(std::string("reference kind ") + kKinds[i]);
    }
    ImGui::EndCombo();
  }
  workspace.place("reference kind");
  if (reference.kind == ReferenceKind::kTraced) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(scaled(70));
    if (ImGui::BeginCombo("##samples", std::to_string(reference.samples).c_str())) {
      for (const int choice : kSampleChoices) {
        if (ImGui::Selectable(std::to_string(choice).c_str(), choice == reference.samples)) reference.samples = choice;
        workspace.place("reference samples " + std::to_string(choice));
      }
      ImGui::EndCombo();
    }
    workspace.place("reference samples");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Shadow rays per view ray and light");
  }
  if (reference.kind != ReferenceKind::kStored) {
    ImGui::SameLine();
    if (reference.active()) {
      if (ImGui::Button("cancel")) reference.cancel(), reference.again = false;
      workspace.place("reference cancel");
      ImGui::SameLine();
      const float share = reference.job() ? reference.job()->progress.load() : 0.0f;
      ImGui::ProgressBar(share, {-1, 0}, reference.job() ? reference.job()->label.c_str() : "");
    } else {
      if (ImGui::Button("start")) reference.start(context);
      workspace.place("reference start");
      ImGui::SameLine();
      ImGui::Checkbox("again when the view changes", &reference.again);
      workspace.place("reference again");
    }
  }
}

void TruthPanel::figures(ResearchContext& context) {
  const auto& metrics = reference.metrics();
  if (!metrics) {
    ImGui::TextColored(kDimColor, "nRMSE -   p99 -   max -");
  } else {
    const ScatterPicture& truth = *reference.truth();
    ImGui::Text("nRMSE %.4g   p99 %.4g   max %.4g   bias %+.4g", metrics->nRmse, metrics->p99, metrics->max,
                metrics->bias);
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("Of R, G, B together, relative to the reference's mean, %.5g", metrics->referenceMean);
    ImGui::SameLine();
    ImGui::TextColored(kDimColor, "at %u x %u,", truth.scatter.width, truth.scatter.height);
    ImGui::SameLine();
    ImGui::Text("%.2f ms", reference.effectMs());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("GPU time of everything that the plugin does at that size");
  }
  if (metrics && reference.valid(context) && !reference.upToDate(context)) {
    ImGui::SameLine();
    ImGui::TextColored(kChangedColor, "updating ...");
  }
  if (reference.truth() && !reference.valid(context)) {
    ImGui::SameLine();
    ImGui::TextColored(kChangedColor, "of an earlier view");
  }
}

void TruthPanel::showChoice(ResearchContext& context) {
  Workspace& workspace = context.workspace;
  const auto choice = [&](const char* label, Show show) {
    if (ImGui::RadioButton(label, show_ == show)) show_ = show;
    workspace.place(std::string("reference show ") + label);
    ImGui::SameLine();
  };
  choice("split", Show::kSplit);
  choice("flicker", Show::kFlicker);
  choice("A", Show::kPicture);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("The present settings: in-scattered radiance times exposure");
  choice("B", Show::kReference);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("The reference");
  choice("error", Show::kError);
  canvas_.buttons(workspace, "reference");
  ImGui::SameLine();
  if (ImGui::SmallButton("store A")) reference.store();
  workspace.place("reference store");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Keeps the present picture, to compare other settings with it");
  if (show_ != Show::kError) return;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(scaled(60));
  ImGui::DragFloat("##most", &mostError_, 0.002f, 1e-4f, 10, "%.3g",
                   ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic);
  workspace.place("reference error range");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Error at the ends of the colours, relative to the reference's mean");
}

/// Brings the textures up to date.
void TruthPanel::map(ResearchContext& context) {
  const ScatterPicture* a = reference.picture();
  const ScatterPicture* b = reference.truth();
  const auto exposure = static_cast<float>(context.session.table().value("view.exposure"));
  if (!a || !b || !reference.metrics() ||
      (mapped_ == reference.version() && mappedExposure_ == exposure && mappedError_ == mostError_))
    return;
  mapped_ = reference.version(), mappedExposure_ = exposure, mappedError_ = mostError_;
  const std::uint32_t width = a->scatter.width, height = a->scatter.height;
  const Stretch stretch{4, false, 0, 1 / std::max(exposure, 1e-6f)};
  // Both with three channels: a marched reference has no transmittance.
  const auto rgb = [](const image::FloatImage& picture) {
    std::vector<float> values;
    values.reserve(std::size_t{picture.width} * picture.height * 3);
    for (std::size_t i = 0; i + picture.channels <= picture.values.size(); i += picture.channels)
      for (std::size_t c = 0; c < 3; ++c) values.push_back(picture.values[i + c]);
    return values;
  };
  const std::vector<float> first = rgb(a->scatter), second = rgb(b->scatter);
  for (auto done :
       {picture_.set(context.renderer, width, height, stretched(first, 3, stretch)),
        reference_.set(context.renderer, width, height, stretched(second, 3, stretch)),
        error_.set(context.renderer, width, height,
                   errorMap(first, second, 3, mostError_ * static_cast<float>(reference.metrics()->referenceMean)))})
    if (!done) context.workspace.tell(done.error().message, true);
}

void TruthPanel::picture(ResearchContext& context) {
  map(context);
  const ScatterPicture* a = reference.picture();
  const ScatterPicture* b = reference.truth();
  const glm::uvec2 size = a ? glm::uvec2(a->scatter.width, a->scatter.height) : glm::uvec2(0);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const bool second = std::fmod(ImGui::GetTime(), 2 * kFlickerSeconds) >= kFlickerSeconds;
  if (show_ == Show::kFlicker)
    context.workspace.drawAgain(kFlickerSeconds - std::fmod(ImGui::GetTime(), kFlickerSeconds));
  const bool showsB = show_ == Show::kReference || (show_ == Show::kFlicker && second);
  const ViewTexture& texture = show_ == Show::kError ? error_ : showsB ? reference_ : picture_;
  canvas_.dragTaken = dividerHeld_;
  const auto seen =
      canvas_.begin(context.workspace, "reference", {room.x, std::max(room.y - line, 20.0f)}, size, texture);
  const char* waiting = reference.valid(context) ? "rendering the present settings ..."
                        : reference.active()     ? "the first picture comes soon ..."
                                                 : "start a reference to compare with";
  if (!a)
    seen.list->AddText(toIm(seen.low + 8.0f), ImGui::GetColorU32(kDimColor), waiting);
  else if (show_ == Show::kSplit)
    divider(seen, context, glm::vec2(size));
  else if (show_ == Show::kError)
    scaleBar(seen);
  else
    seen.list->AddText(toIm(seen.low + 6.0f), IM_COL32(255, 255, 255, 200), showsB ? "B" : "A");
  canvas_.end(seen);
  if (!a || !b || !seen.hovered) {
    ImGui::TextUnformatted("");
    return;
  }
  const auto x = static_cast<std::uint32_t>(seen.hovered->x), y = static_cast<std::uint32_t>(seen.hovered->y);
  const auto value = [&](const image::FloatImage& picture, std::uint32_t c) {
    return static_cast<double>(picture.at(x, y, c));
  };
  ImGui::Text("%u %u   A %.4g %.4g %.4g   B %.4g %.4g %.4g", x, y, value(a->scatter, 0), value(a->scatter, 1),
              value(a->scatter, 2), value(b->scatter, 0), value(b->scatter, 1), value(b->scatter, 2));
}

/// A is drawn already; B over it, right of the divider, which the mouse drags.
void TruthPanel::divider(const ViewCanvas::Seen& seen, ResearchContext& context, glm::vec2 image) {
  const glm::vec2 low = seen.pointOf({0, 0}), high = seen.pointOf(image);
  const float x = low.x + divider_ * (high.x - low.x);
  if (reference_) {
    seen.list->PushClipRect({x, seen.low.y}, toIm(seen.low + seen.size), true);
    seen.list->AddImage(reference_.id(seen.transform->scale() >= 1), toIm(low), toIm(high));
    seen.list->PopClipRect();
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool near = ImGui::IsItemHovered() && std::abs(mouse.x - x) < 6;
  if (near && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) dividerHeld_ = true;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) dividerHeld_ = false;
  if (dividerHeld_) divider_ = std::clamp((mouse.x - low.x) / std::max(high.x - low.x, 1.0f), 0.0f, 1.0f);
  if (near || dividerHeld_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  seen.list->AddLine({x, std::max(low.y, seen.low.y)}, {x, std::min(high.y, seen.low.y + seen.size.y)},
                     near || dividerHeld_ ? IM_COL32(255, 205, 90, 255) : IM_COL32(255, 255, 255, 180), 2);
  seen.list->AddText({x - 16, seen.low.y + 4}, IM_COL32(255, 255, 255, 220), "A");
  seen.list->AddText({x + 8, seen.low.y + 4}, IM_COL32(255, 255, 255, 220), "B");
  context.workspace.widgets["reference divider"] = {x - 3, seen.low.y, 6, seen.size.y};
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", static_cast<double>(divider_));
  context.workspace.facts["reference divider"] = text;
}

void TruthPanel::scaleBar(const ViewCanvas::Seen& seen) const {
  const ImVec2 low{seen.low.x + 10, seen.low.y + seen.size.y - 36};
  seen.list->AddRectFilled({low.x - 6, low.y - 6}, {low.x + kBarWidth + 6, low.y + kBarHeight + 6 + scaled(14)},
                           IM_COL32(0, 0, 0, 170), 3);
  constexpr int kParts = 60;
  for (int i = 0; i < kParts; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / kParts;
    const Rgb c = signedColour(share * 2 - 1);
    seen.list->AddRectFilled({low.x + kBarWidth * static_cast<float>(i) / kParts, low.y},
                             {low.x + kBarWidth * static_cast<float>(i + 1) / kParts, low.y + kBarHeight},
                             IM_COL32(c[0], c[1], c[2], 255));
  }
  const auto label = [&](float share, double value, float align) {
    char text[32];
    std::snprintf(text, sizeof text, value == 0 ? "0" : "%+.3g", value);
    seen.list->AddText({low.x + kBarWidth * share - ImGui::CalcTextSize(text).x * align, low.y + kBarHeight + 2},
                       IM_COL32(255, 255, 255, 230), text);
  };
  label(0, -static_cast<double>(mostError_), 0);
  label(0.5f, 0, 0.5f);
  label(1, static_cast<double>(mostError_), 1);
}

}  // namespace tyndall::editor
