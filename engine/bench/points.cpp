#include "bench/points.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "base/hash.hpp"

namespace tyndall::bench {
namespace {

constexpr const char* kSelector = "volumetrics.technique";

/// The techniques that are built, "none" aside, in the order of the table.
std::vector<std::string> builtTechniques(const params::Table& table) {
  std::vector<std::string> names;
  const params::Parameter* selector = table.find(kSelector);
  if (!selector) return names;
  for (std::size_t i = 0; i < selector->choices.size(); ++i)
    if (selector->choices[i] != "none" && (selector->built.empty() || selector->built[i]))
      names.push_back(selector->choices[i]);
  return names;
}

class Planner {
 public:
  Planner(const Sweep& sweep, app::Catalogue& catalogue, const std::string& level, std::uint64_t content,
          std::uint32_t camera)
      : sweep_(sweep), catalogue_(catalogue), level_(level), camera_(camera) {
    // What errors are taken against is a part of a point too: another truth, march or level file makes it another one.
    std::string text = std::to_string(sweep.errorSize.first) + "x" + std::to_string(sweep.errorSize.second) + " " +
                       std::to_string(sweep.truthSamples) + " " + std::to_string(sweep.motion.frames) + " " +
                       std::to_string(sweep.motion.turn) + " " + std::to_string(sweep.motion.seconds);
    for (const auto& [id, value] : sweep.march) text += " " + id + "=" + value;
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx",
                  static_cast<unsigned long long>(Hash().text(text).add(content).value()));
    references_ = hash;
  }

  Result<std::vector<PlannedPoint>> plan() {
    const std::vector<std::string> techniques = builtTechniques(catalogue_.table());
    for (const std::string& technique : techniques) {
      if (sweep_.everyTechnique)
        if (auto added = add(technique, technique, "default", {}, {"error_time"}, {}, sweep_.size); !added)
          return added.error();
      for (const Knob& knob : sweep_.knobs)
        if (auto added = addKnob(technique, knob); !added) return added.error();
      for (const Size& size : sweep_.resolutions)
        if (auto added = add(technique, technique, std::to_string(size.first) + "x" + std::to_string(size.second), {},
                             {"resolution"}, {}, size);
            !added)
          return added.error();
      if (sweep_.motion.frames > 0) {
        if (auto added = add(technique, technique, "moving", {}, {"motion"}, {}, sweep_.size); !added)
          return added.error();
      }
    }
    for (const Single& single : sweep_.singles) {
      const auto technique = single.settings.find(kSelector);
      if (auto added = add(technique == single.settings.end() ? "" : technique->second, single.series, single.label,
                           single.settings, single.plots, {}, sweep_.size);
          !added)
        return added.error();
      if (!added_) continue;  // the same point stands already
      points_.back().figures.paper = single.paper;
      if (single.baseline) baseline_ = points_.back().figures.key;
    }
    for (PlannedPoint& point : points_)
      if (point.figures.paper) point.figures.baselineKey = baseline_;
    catalogue_.table().resetToDefaults();
    return std::move(points_);
  }

 private:
  bool reads(const std::string& technique, const std::string& id) {
    for (const auto& plugin : catalogue_.plugins())
      for (const host::TechniqueInfo& t : plugin->techniques())
        if (t.id == technique) return std::find(t.reads.begin(), t.reads.end(), id) != t.reads.end();
    return false;
  }

  Result<void> addKnob(const std::string& technique, const Knob& knob) {
    if (!catalogue_.table().find(knob.id))
      return catalogue_.table().setText(knob.id, knob.values.front());  // says what is near
    // Parameters of the engine (shadow maps, say) bear on every technique.
    const bool engines = catalogue_.table().find(knob.id)->owner == "engine";
    if (!engines && !reads(technique, knob.id)) return {};
    Assignments with;
    std::string suffix;
    for (const auto& [id, value] : knob.with)
      if (reads(technique, id)) with[id] = value, suffix += ", " + shortName(id) + " = " + value;
    for (const std::string& value : knob.values) {
      Assignments settings = with;
      settings[knob.id] = value;
      for (const std::string& id : knob.together) settings[id] = value;
      if (auto added = add(technique, technique + suffix, shortName(knob.id) + " = " + value, settings, knob.plots,
                           {{knob.id, value}}, sweep_.size);
          !added)
        return added;
    }
    return {};
  }

  static std::string shortName(const std::string& id) { return id.starts_with("volumetrics.") ? id.substr(12) : id; }

  Result<void> add(const std::string& technique, const std::string& series, const std::string& label,
                   const Assignments& settings, const std::vector<std::string>& plots,
                   const std::optional<std::pair<std::string, std::string>>& knob, Size size) {
    PlannedPoint point;
    point.all = sweep_.settings;
    Assignments own = settings;
    if (!technique.empty()) own[kSelector] = technique;
    for (const auto& [id, value] : own) {
      if (id.starts_with("medium."))
        return badCall("sweep " + sweep_.name + ": " + id +
                       " is set for single points; the references are made for one medium, so \"settings\" of the "
                       "whole sweep would be right");
      point.all[id] = value;
    }
    params::Table& table = catalogue_.table();
    if (auto applied = applySettings(table, point.all); !applied)
      return Error{"sweep " + sweep_.name + ": " + applied.error().message, applied.error().kind};
    // Canonical: what differs from the defaults, in the table's own words.
    std::string text;
    for (const params::Parameter& p : table.parameters())
      if (table.changed(p.id) || p.id == kSelector) text += " " + p.id + "=" + params::toText(p, table.value(p.id));
    PointFigures& f = point.figures;
    f.level = level_, f.camera = camera_, f.size = size, f.series = series, f.technique = technique, f.label = label,
    f.plots = plots, f.knob = knob;
    f.settings = own;
    point.measurement = level_ + " " + std::to_string(camera_) + " " + std::to_string(size.first) + "x" +
                        std::to_string(size.second) + text;
    point.motion = sweep_.motion.frames > 0 && std::find(plots.begin(), plots.end(), "motion") != plots.end();
    if (point.motion) point.measurement += "#motion";
    f.key = point.measurement + " | " + series + ", " + label + " | " + references_;
    added_ = keys_.insert(f.key).second;
    if (!added_) return {};
    points_.push_back(std::move(point));
    return {};
  }

  const Sweep& sweep_;
  app::Catalogue& catalogue_;
  std::string level_;
  std::uint32_t camera_;
  std::vector<PlannedPoint> points_;
  std::set<std::string> keys_;
  std::string baseline_, references_;
  bool added_ = false;  ///< by the last add()
};

}  // namespace

Result<std::vector<PlannedPoint>> pointsOf(const Sweep& sweep, app::Catalogue& catalogue, const std::string& level,
                                           std::uint64_t content, std::uint32_t camera) {
  return Planner(sweep, catalogue, level, content, camera).plan();
}

Result<void> applySettings(params::Table& table, const Assignments& assignments) {
  table.resetToDefaults();
  for (const auto& [id, value] : assignments)
    if (auto set = table.setText(id, value); !set) return set;
  return {};
}

}  // namespace tyndall::bench
