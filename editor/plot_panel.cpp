#include "plot_panel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "image/metrics.hpp"

namespace tyndall::editor {
namespace {

constexpr float kLeft = 56, kBottom = 34, kTop = 8, kRight = 14;  // margins of the chart, points at normal text
constexpr float kReach = 9;                                       // how near the mouse takes a point

const params::Parameter* selectorOf(app::Session& session) {
  const host::Plugin& plugin = session.catalogue().effectPlugin();
  return plugin.selector() < plugin.parameters().size() ? &plugin.parameters()[plugin.selector()] : nullptr;
}

/// A colour of its own for each label, evenly round the circle of hues.
ImU32 colourOf(std::size_t index, std::size_t count) {
  float r, g, b;
  ImGui::ColorConvertHSVtoRGB(static_cast<float>(index) / static_cast<float>(std::max<std::size_t>(count, 1)), 0.62f,
                              0.95f, r, g, b);
  return ImGui::ColorConvertFloat4ToU32({r, g, b, 1});
}

}  // namespace

/// One entry for each technique, with the present settings otherwise.
void PlotPanel::fill(ResearchContext& context) {
  const bool sameView = context.shot.sameTruth(shot_);
  std::erase_if(entries_, [&](const Entry& entry) { return !entry.extra || !sameView; });
  ++run_;
  shot_ = context.shot;
  const params::Parameter* selector = selectorOf(context.session);
  const host::Plugin& plugin = context.session.catalogue().effectPlugin();
  for (const host::TechniqueInfo& technique : plugin.techniques()) {
    Entry entry;
    entry.label = technique.id;
    entry.values = context.shot.values;
    if (const auto enabled = entry.values.find(plugin.id() + ".enabled"); enabled != entry.values.end())
      enabled->second = 1;
    if (selector) {
      const auto value = params::fromText(*selector, technique.id);
      if (!value) continue;  // a technique that the selector does not offer cannot be chosen by anyone
      entry.values[selector->id] = *value;
    }
    entries_.push_back(std::move(entry));
  }
}

void PlotPanel::measureNext(ResearchContext& context, Reference& reference) {
  if (!measuring_ || running(job_)) return;
  if (!context.shot.sameTruth(shot_)) {
    measuring_ = false;
    context.workspace.tell("plot: the view or the medium has changed; what was not measured yet is left out", false);
    return;
  }
  if (!reference.full(context)) {
    if (reference.active()) return;
    // Asked for once: what cannot be made would fail again in every frame, and a stored picture is never made.
    if (referenceAsked_ || reference.kind == ReferenceKind::kStored) {
      measuring_ = false;
      if (reference.kind == ReferenceKind::kStored)
        context.workspace.tell("plot: the stored picture is of another view or size; choose rays or a march", true);
      return;
    }
    referenceAsked_ = true;
    reference.start(context);
    return;
  }
  const auto next = std::find_if(entries_.begin(), entries_.end(),
                                 [](const Entry& entry) { return !entry.measured && entry.failure.empty(); });
  if (next == entries_.end()) {
    measuring_ = false;
    return;
  }
  Laboratory* laboratory = context.laboratory();
  if (!laboratory) {
    measuring_ = false;
    return;
  }
  RenderTask task;
  task.shot = shot_;
  task.shot.values = next->values;
  task.repeats = static_cast<std::uint32_t>(repeats_);
  // By value: the reference may be another by the time the result is there.
  const auto truth = std::make_shared<image::FloatImage>(reference.source()->scatter);
  const std::size_t index = static_cast<std::size_t>(next - entries_.begin());
  job_ = laboratory->render(next->label, task, [this, truth, index, run = run_](Result<RenderResult> result) {
    if (run != run_ || index >= entries_.size()) return;
    Entry& entry = entries_[index];
    if (!result) {
      entry.failure = result.error().message;
      return;
    }
    const auto metrics = image::compare(result->scatter, *truth);
    if (!metrics) {
      entry.failure = metrics.error().message;
      return;
    }
    entry.point = {result->effectMs, metrics->nRmse};
    entry.measured = true;
  });
}

void PlotPanel::draw(ResearchContext& context, Reference& reference) {
  if (!open) {
    if (job_) job_->cancel();
    measuring_ = false;
    return;
  }
  if (measuring_) reference.update(context);
  measureNext(context, reference);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x * 0.3f, std::max(display.y * 0.3f, 40.0f)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize({scaled(460), scaled(380)}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({320, 220}, {16384, 16384});
  if (ImGui::Begin("Error against time", &open, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    Workspace& workspace = context.workspace;
    if (measuring_) {
      if (ImGui::Button("cancel")) {
        if (job_) job_->cancel();
        if (reference.active() && !reference.full(context)) reference.cancel();
        measuring_ = false;
      }
      workspace.place("plot cancel");
      ImGui::SameLine();
      ImGui::TextUnformatted(running(job_) ? ("measuring " + job_->label).c_str() : "the reference comes first");
    } else {
      if (ImGui::Button("measure all techniques")) fill(context), measuring_ = true, referenceAsked_ = false;
      workspace.place("plot measure");
      ImGui::SameLine();
      if (ImGui::Button("add the present settings")) {
        if (!context.shot.sameTruth(shot_)) entries_.clear(), ++run_, shot_ = context.shot;
        entries_.push_back(
            {context.session.catalogue().techniqueName() + " +", context.shot.values, true, false, {}, {}});
        measuring_ = true;
        referenceAsked_ = false;
      }
      workspace.place("plot add");
      ImGui::SameLine();
      ImGui::SetNextItemWidth(scaled(60));
      if (ImGui::InputInt("repeats", &repeats_, 0)) repeats_ = std::clamp(repeats_, 1, 100);
      if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Frames that each is timed over, after a warm-up; the median counts");
    }
    if (!entries_.empty() && !context.shot.sameTruth(shot_)) {
      ImGui::SameLine();
      ImGui::TextColored(kChangedColor, "of an earlier view");
    }
    chart(context);
  }
  ImGui::End();
  tell(context.workspace);
}

void PlotPanel::chart(ResearchContext& context) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size{std::max(room.x, 120.0f), std::max(room.y, 100.0f)};
  ImGui::InvisibleButton("chart", size);
  context.workspace.place("plot chart");
  const bool hovered = ImGui::IsItemHovered(), clicked = ImGui::IsItemClicked();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 from{low.x + scaled(kLeft), low.y + kTop}, to{low.x + size.x - kRight, low.y + size.y - scaled(kBottom)};
  list.AddRectFilled(from, to, IM_COL32(18, 18, 20, 255));
  std::vector<double> times, errors;
  std::vector<PlotPoint> points;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (entries_[i].measured && entries_[i].point.milliseconds > 0 && entries_[i].point.error > 0) {
      times.push_back(entries_[i].point.milliseconds), errors.push_back(entries_[i].point.error);
      points.push_back(entries_[i].point), shown.push_back(i);
    }
  const LogAxis x = axisFor(times), y = axisFor(errors);
  const auto place = [&](const PlotPoint& p) {
    return ImVec2(from.x + static_cast<float>(x.share(p.milliseconds)) * (to.x - from.x),
                  to.y - static_cast<float>(y.share(p.error)) * (to.y - from.y));
  };
  const ImU32 text = IM_COL32(200, 205, 215, 255), line = IM_COL32(70, 72, 80, 255), faint = IM_COL32(42, 43, 48, 255);
  const auto grid = [&](const LogAxis& axis, bool across) {
    const auto ticks = axis.ticks();
    const bool few = std::count_if(ticks.begin(), ticks.end(), [](const auto& t) { return t.major; }) <
                     2;  // less than two powers of ten: label more
    for (const LogAxis::Tick& tick : ticks) {
      const float at = across ? from.x + static_cast<float>(axis.share(tick.value)) * (to.x - from.x)
                              : to.y - static_cast<float>(axis.share(tick.value)) * (to.y - from.y);
      if (across)
        list.AddLine({at, from.y}, {at, to.y}, tick.major ? line : faint);
      else
        list.AddLine({from.x, at}, {to.x, at}, tick.major ? line : faint);
      const int digit =
          static_cast<int>(std::lround(tick.value / std::pow(10, std::floor(std::log10(tick.value) + 1e-9))));
      if (!tick.major && !(few && (digit == 2 || digit == 5))) continue;
      const std::string label = tickText(tick.value);
      const ImVec2 extent = ImGui::CalcTextSize(label.c_str());
      if (across)
        list.AddText({at - extent.x / 2, to.y + 3}, text, label.c_str());
      else
        list.AddText({from.x - extent.x - 5, at - extent.y / 2}, text, label.c_str());
    }
  };
  grid(x, true);
  grid(y, false);
  list.AddRect(from, to, line);
  const char* xName = "ms of the plugin's passes (GPU)";
  list.AddText({(from.x + to.x - ImGui::CalcTextSize(xName).x) / 2, to.y + scaled(17)}, text, xName);
  list.AddText({low.x + 2, from.y}, text, "nRMSE");

  const auto front = paretoFront(points);
  for (std::size_t i = 0; i + 1 < front.size(); ++i) {
    // A staircase: between two points nothing is better than the faster one's error.
    const ImVec2 a = place(points[front[i]]), b = place(points[front[i + 1]]);
    list.AddLine(a, {b.x, a.y}, IM_COL32(120, 220, 110, 130), 1.5f);
    list.AddLine({b.x, a.y}, b, IM_COL32(120, 220, 110, 130), 1.5f);
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Entry* nearest = nullptr;
  float distance = kReach;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Entry& entry = entries_[shown[i]];
    const ImVec2 p = place(points[i]);
    const bool best = std::find(front.begin(), front.end(), i) != front.end();
    list.AddCircleFilled(p, 5, colourOf(shown[i], entries_.size()));
    if (best) list.AddCircle(p, 7, IM_COL32(120, 220, 110, 255), 0, 1.5f);
    const ImVec2 extent = ImGui::CalcTextSize(entry.label.c_str());
    const float side = p.x + 10 + extent.x > to.x ? -10 - extent.x : 10;
    list.AddText({p.x + side, p.y - extent.y / 2}, text, entry.label.c_str());
    context.workspace.widgets["plot " + entry.label] = {p.x - 4, p.y - 4, 8, 8};
    if (const float d = std::hypot(mouse.x - p.x, mouse.y - p.y); hovered && d < distance)
      distance = d, nearest = &entry;
  }
  float below = from.y + 6;
  for (const Entry& entry : entries_) {
    if (entry.failure.empty()) continue;
    list.AddText({from.x + 8, below}, ImGui::GetColorU32(kErrorColor), (entry.label + ": " + entry.failure).c_str());
    below += ImGui::GetTextLineHeightWithSpacing();
  }
  if (entries_.empty())
    list.AddText({from.x + 10, from.y + 10}, ImGui::GetColorU32(kDimColor),
                 "Every technique with the present settings, at the present size");
  if (nearest) tooltip(context, *nearest);
  if (nearest && clicked) apply(context, *nearest);
}

std::string PlotPanel::changesOf(const ResearchContext& context, const Entry& entry) const {
  std::string lines;
  for (const params::Parameter& parameter : context.session.table().parameters()) {
    const auto value = entry.values.find(parameter.id);
    if (value != entry.values.end() && value->second != parameter.defaultValue)
      lines += "\n" + parameter.id + " = " + params::toText(parameter, value->second);
  }
  return lines;
}

void PlotPanel::tooltip(const ResearchContext& context, const Entry& entry) const {
  ImGui::SetTooltip("%s\n%.3f ms   nRMSE %.4g\nsettings besides the defaults:%s\nclick to apply them",
                    entry.label.c_str(), entry.point.milliseconds, entry.point.error,
                    changesOf(context, entry).c_str());
}

void PlotPanel::apply(ResearchContext& context, const Entry& entry) {
  params::Table& table = context.session.table();
  for (const auto& [id, value] : entry.values)
    if (table.find(id) && table.value(id) != value)
      if (auto set = table.set(id, value); !set) return context.workspace.tell(set.error().message, true);
  context.workspace.changed = true;
  context.workspace.tell("settings of " + entry.label + " applied", false);
}

void PlotPanel::tell(Workspace& workspace) const {
  std::string line;
  char text[96];
  for (const Entry& entry : entries_) {
    if (!entry.measured) continue;
    std::snprintf(text, sizeof text, "%s%s %.6g %.9g", line.empty() ? "" : "; ", entry.label.c_str(),
                  entry.point.milliseconds, entry.point.error);
    line += text;
  }
  workspace.facts["plot"] = line;
  workspace.facts["plot state"] = measuring_ ? "measuring" : "idle";
}

}  // namespace tyndall::editor
