// Reads results.json field by field; the first field that is wrong is remembered with its path.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/json_shape.hpp"
#include "results.hpp"
#include "text.hpp"

namespace tyndall::bench::report {
namespace {

using Json = nlohmann::json;

constexpr double kLargest = 1e18;

/// A place in the file. Missing and null are the same: nothing.
class Field {
 public:
  Field(const Json* json, std::string path, std::string& problem)
      : json_(json), path_(std::move(path)), problem_(&problem) {}

  bool empty() const { return !json_ || json_->is_null(); }
  const std::string& path() const { return path_; }

  Field operator[](const std::string& key) const {
    const std::string path = path_.empty() ? key : path_ + "." + key;
    if (empty() || !json_->is_object()) return {nullptr, path, *problem_};
    const auto found = json_->find(key);
    return {found == json_->end() ? nullptr : &*found, path, *problem_};
  }

  /// False for nothing, and for anything that is no object (which is a problem).
  bool object() const { return !empty() && (json_->is_object() || wrong("an object")); }

  std::vector<Field> items() const {
    std::vector<Field> all;
    if (empty() || (!json_->is_array() && !wrong("a list"))) return all;
    for (std::size_t i = 0; i < json_->size(); ++i)
      all.push_back({&(*json_)[i], path_ + "[" + std::to_string(i) + "]", *problem_});
    return all;
  }

  std::string text() const {
    if (empty() || (!json_->is_string() && !wrong("text"))) return {};
    return json_->get<std::string>();
  }

  Number number() const {
    if (empty() || (!json_->is_number() && !wrong("a number"))) return {};
    const double value = json_->get<double>();
    // Beyond any time, size or count; sums and ratios of what is left stay finite.
    if (!(std::abs(value) <= kLargest)) return wrong("a number of at most 1e18"), Number();
    return value;
  }

  /// Times, errors, counts.
  Number amount() const {
    const Number value = number();
    if (value && *value < 0) return wrong("0 or more"), Number();
    return value;
  }

  int integer() const {
    const Number value = amount();
    if (!value) return 0;
    if (*value != std::floor(*value) || *value > 1e9) return wrong("a whole number of at most 1e9"), 0;
    return static_cast<int>(*value);
  }

  std::optional<bool> boolean() const {
    if (empty() || (!json_->is_boolean() && !wrong("true or false"))) return {};
    return json_->get<bool>();
  }

  Value value() const {
    if (empty()) return {};
    if (json_->is_string()) return {json_->get<std::string>(), {}};
    if (json_->is_number()) return {exact(json_->get<double>()), json_->get<double>()};
    return {json_->dump(), {}};  // true, false; lists and objects as they are written
  }

  Settings settings() const {
    Settings all;
    if (!object()) return all;
    for (const auto& item : json_->items()) all[item.key()] = (*this)[item.key()].value();
    return all;
  }

  /// Remembers the first problem; always false.
  bool wrong(const std::string& wanted) const {
    if (!problem_->empty()) return false;
    std::string found = json_ ? json_->dump(-1, ' ', false, Json::error_handler_t::replace) : "nothing";
    if (json_ && json_->is_structured()) found = json_->is_array() ? "a list" : "an object";
    if (found.size() > 60) found = found.substr(0, 57) + "...";
    *problem_ = (path_.empty() ? "the file" : path_) + " is " + found + "; " + wanted + " would be right";
    return false;
  }

 private:
  const Json* json_;
  std::string path_;
  std::string* problem_;
};

std::optional<Spread> spread(const Field& f) {
  if (!f.object()) return {};
  const Spread s = {f["median"].amount().value_or(0), f["low"].amount(), f["high"].amount(), f["n"].amount()};
  if (f["median"].empty()) return {};
  if (s.low && *s.low > s.median) f["low"].wrong("at most the median");
  if (s.high && *s.high < s.median) f["high"].wrong("at least the median");
  return s;
}

std::optional<Region> region(const Field& f) {
  if (!f.object()) return {};
  const Region r = {f["nrmse"].amount().value_or(0), f["p99"].amount(), f["maximum"].amount(), f["bias"].number(),
                    f["pixels"].amount()};
  if (f["nrmse"].empty()) return {};
  return r;
}

Split split(const Field& f) {
  if (!f.object()) return {};
  return {region(f["all"]), region(f["silhouettes"]), region(f["interior"]), region(f["light"])};
}

Point point(const Field& f) {
  Point p;
  if (!f.object()) {
    if (f.empty()) f.wrong("an object");
    return p;
  }
  p.key = f["key"].text();
  p.level = f["level"].text();
  p.camera = f["camera"].integer();
  p.seconds = f["seconds"].number();
  const auto size = f["size"].items();
  if (size.size() == 2)
    p.width = size[0].integer(), p.height = size[1].integer();
  else if (!f["size"].empty())
    f["size"].wrong("[width, height]");
  p.technique = f["technique"].text();
  p.series = f["series"].text();
  if (p.series.empty()) p.series = p.technique.empty() ? "unnamed" : p.technique;
  p.label = f["label"].text();
  for (const Field& plot : f["plot"].items()) p.plots.push_back(plot.text());
  if (const Field knob = f["knob"]; knob.object()) p.knob = Knob{knob["id"].text(), knob["value"].value()};
  p.settings = f["settings"].settings();
  p.frame = spread(f["gpu_ms"]);
  p.volumetrics = spread(f["volumetrics_ms"]);
  p.shadow = spread(f["shadow_ms"]);
  for (const Field& pass : f["passes"].items())
    if (pass.object()) p.passes.push_back({pass["name"].text(), pass["owner"].text(), pass["ms"].amount().value_or(0)});
  p.memoryBytes = f["memory_bytes"].amount();
  p.floorBytes = f["floor_bytes"].amount();
  if (const Field error = f["error"]; error.object()) p.truth = split(error["truth"]), p.march = split(error["march"]);
  if (const Field t = f["temporal"]; t.object()) p.temporal = Temporal{t["nrmse_mean"].amount(), t["flicker"].amount()};
  if (const Field paper = f["paper"]; paper.object())
    p.paper = Paper{paper["paper"].text(),        paper["table"].text(),       paper["row"].text(),
                    paper["baseline_key"].text(), paper["figure_ms"].amount(), paper["figure_ratio"].amount()};
  if (const Field failed = f["failed"]; !failed.empty()) p.failed = failed.text();
  return p;
}

Level level(const Field& f) {
  Level l;
  if (!f.object()) {
    if (f.empty()) f.wrong("an object");
    return l;
  }
  l.name = f["name"].text();
  l.camera = f["camera"].integer();
  l.triangles = f["triangles"].amount();
  l.lights = f["lights"].amount();
  l.lightInView = f["light_in_view"].boolean();
  l.truthSamples = f["truth_samples"].amount();
  l.truthSelfNrmse = f["truth_self_nrmse"].amount();
  return l;
}

}  // namespace

bool Point::in(const std::string& plot) const { return std::find(plots.begin(), plots.end(), plot) != plots.end(); }

Result<Results> readResults(const std::string& text) {
  const std::string subject = "benchmark results: ";
  if (const std::string shape = jsonShapeProblem(text); !shape.empty())
    return failed(subject + "the JSON " + shape + "; the text of a results.json is wanted");
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& e) {
    const auto before = text.substr(0, std::min(e.byte, text.size()));
    return failed(subject + "not valid JSON, line " +
                  std::to_string(1 + std::count(before.begin(), before.end(), '\n')) +
                  "; the text of a results.json is wanted");
  } catch (const Json::exception&) {  // a number that no double holds
    return failed(subject + "a number is too large; the text of a results.json is wanted");
  }

  std::string problem;
  const Field root(&json, "", problem);
  if (root.empty())
    root.wrong("an object");
  else
    root.object();
  if (problem.empty() && root["format"].text() != "tyndall-bench") root["format"].wrong("\"tyndall-bench\"");
  if (problem.empty() && root["version"].number() != Number(1)) root["version"].wrong("1");
  if (problem.empty() && root["points"].empty()) root["points"].wrong("a list");
  if (!problem.empty()) return failed(subject + problem);

  Results r;
  r.device = root["device"].text();
  r.driver = root["driver"].text();
  r.sweep = root["sweep"].text();
  r.started = root["started"].text();
  r.command = root["command"].text();
  r.copyGbS = root["copy_gb_s"].amount();
  r.settings = root["settings"].settings();
  for (const Field& f : root["levels"].items()) r.levels.push_back(level(f));
  for (const Field& f : root["points"].items()) r.points.push_back(point(f));
  if (!problem.empty()) return failed(subject + problem);

  for (const Point& p : r.points) {
    const auto same = [&](const Level& l) { return l.name == p.level && l.camera == p.camera; };
    if (std::none_of(r.levels.begin(), r.levels.end(), same))
      r.levels.push_back({p.level, p.camera, {}, {}, {}, {}, {}});
  }
  return r;
}

}  // namespace tyndall::bench::report
