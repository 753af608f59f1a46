// results.json, written and read again.
#include <nlohmann/json.hpp>

#include "base/json_shape.hpp"
#include "bench/results.hpp"

namespace tyndall::bench {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json toJson(const Spread& s) { return {{"median", s.median}, {"low", s.low}, {"high", s.high}, {"n", s.count}}; }
Spread spreadFrom(const Json& j) { return {j.at("median"), j.at("low"), j.at("high"), j.at("n")}; }

Json toJson(const std::optional<Errors>& e) {
  if (!e) return {};
  return {{"nrmse", e->nrmse}, {"p99", e->p99}, {"maximum", e->maximum}, {"bias", e->bias}, {"pixels", e->pixels}};
}
std::optional<Errors> errorsFrom(const Json& j) {
  if (j.is_null()) return std::nullopt;
  return Errors{j.at("nrmse"), j.at("p99"), j.at("maximum"), j.at("bias"), j.at("pixels")};
}

Json toJson(const std::optional<SplitErrors>& e) {
  if (!e) return {};
  return {{"all", toJson(e->all)},
          {"silhouettes", toJson(e->silhouettes)},
          {"interior", toJson(e->interior)},
          {"light", toJson(e->light)}};
}
std::optional<SplitErrors> splitFrom(const Json& j) {
  if (j.is_null()) return std::nullopt;
  return SplitErrors{errorsFrom(j.at("all")), errorsFrom(j.at("silhouettes")), errorsFrom(j.at("interior")),
                     errorsFrom(j.at("light"))};
}

Json toJson(const PointFigures& p) {
  Json j = {{"key", p.key},
            {"level", p.level},
            {"camera", p.camera},
            {"seconds", p.seconds},
            {"size", {p.size.first, p.size.second}},
            {"series", p.series},
            {"technique", p.technique},
            {"label", p.label},
            {"plot", p.plots}};
  j["knob"] = p.knob ? Json{{"id", p.knob->first}, {"value", p.knob->second}} : Json();
  j["settings"] = p.settings;
  const bool measured = p.failure.empty();
  j["gpu_ms"] = measured ? toJson(p.gpu) : Json();
  j["volumetrics_ms"] = measured ? toJson(p.volumetrics) : Json();
  j["shadow_ms"] = measured ? toJson(p.shadows) : Json();
  j["passes"] = Json::array();
  for (const PassMs& pass : p.passes)
    j["passes"].push_back({{"name", pass.name}, {"owner", pass.owner}, {"ms", pass.milliseconds}});
  j["memory_bytes"] = p.memoryBytes;
  j["floor_bytes"] = orNull(p.movedBytes);
  j["error"] = {{"truth", toJson(p.truth)}, {"march", toJson(p.march)}};
  j["temporal"] = p.motionError && p.flicker ? Json{{"nrmse_mean", *p.motionError}, {"flicker", *p.flicker}} : Json();
  j["paper"] = nullptr;
  if (p.paper)
    j["paper"] = {{"paper", p.paper->paper},
                  {"table", p.paper->table},
                  {"row", p.paper->row},
                  {"figure_ms", orNull(p.paper->milliseconds)},
                  {"figure_ratio", orNull(p.paper->ratio)},
                  {"baseline_key", p.baselineKey.empty() ? Json() : Json(p.baselineKey)}};
  j["failed"] = measured ? Json() : Json(p.failure);
  return j;
}

PointFigures pointFrom(const Json& j) {
  PointFigures p;
  p.key = j.at("key"), p.level = j.at("level"), p.camera = j.at("camera"), p.seconds = j.at("seconds");
  p.size = {j.at("size").at(0), j.at("size").at(1)};
  p.series = j.at("series"), p.technique = j.at("technique"), p.label = j.at("label");
  p.plots = j.at("plot").get<std::vector<std::string>>();
  if (const Json& knob = j.at("knob"); !knob.is_null())
    p.knob = {knob.at("id").get<std::string>(), knob.at("value").get<std::string>()};
  p.settings = j.at("settings").get<Assignments>();
  if (!j.at("failed").is_null()) {
    p.failure = j.at("failed");
  } else {
    p.gpu = spreadFrom(j.at("gpu_ms")), p.volumetrics = spreadFrom(j.at("volumetrics_ms")),
    p.shadows = spreadFrom(j.at("shadow_ms"));
  }
  for (const Json& pass : j.at("passes")) p.passes.push_back({pass.at("name"), pass.at("owner"), pass.at("ms")});
  p.memoryBytes = j.at("memory_bytes");
  if (!j.at("floor_bytes").is_null()) p.movedBytes = j.at("floor_bytes").get<std::uint64_t>();
  p.truth = splitFrom(j.at("error").at("truth"));
  p.march = splitFrom(j.at("error").at("march"));
  if (const Json& t = j.at("temporal"); !t.is_null())
    p.motionError = t.at("nrmse_mean").get<double>(), p.flicker = t.at("flicker").get<double>();
  if (const Json& paper = j.at("paper"); !paper.is_null()) {
    PaperFigure figure{paper.at("paper"), paper.at("table"), paper.at("row"), {}, {}};
    if (!paper.at("figure_ms").is_null()) figure.milliseconds = paper.at("figure_ms").get<double>();
    if (!paper.at("figure_ratio").is_null()) figure.ratio = paper.at("figure_ratio").get<double>();
    if (!paper.at("baseline_key").is_null()) p.baselineKey = paper.at("baseline_key");
    p.paper = figure;
  }
  return p;
}

}  // namespace

std::string resultsJson(const Results& results) {
  Json j = {{"format", "tyndall-bench"},
            {"version", 1},
            {"device", results.device},
            {"driver", results.driver},
            {"sweep", results.sweep},
            {"started", results.started},
            {"command", results.command},
            {"repetitions", results.repetitions},
            {"copy_gb_s", orNull(results.copyGigabytes)},
            {"settings", results.settings}};
  j["levels"] = Json::array();
  for (const LevelFigures& l : results.levels)
    j["levels"].push_back({{"name", l.name},
                           {"camera", l.camera},
                           {"triangles", l.triangles},
                           {"lights", l.lights},
                           {"light_in_view", l.lightInView},
                           {"truth_samples", l.truthSamples},
                           {"truth_self_nrmse", orNull(l.truthSelf)}});
  j["points"] = Json::array();
  for (const PointFigures& p : results.points) j["points"].push_back(toJson(p));
  return j.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Results> readResults(const std::string& json, const std::string& source) try {
  if (const std::string problem = jsonShapeProblem(json); !problem.empty())
    return failed(source + ": its JSON " + problem + "; results nest 6");
  const Json j = Json::parse(json);
  if (!j.is_object() || j.value("format", "") != "tyndall-bench")
    return failed(source + ": is no result of tyndall bench; a results.json would be right");
  if (j.at("version") != 1)
    return failed(source + ": has version " + j.at("version").dump() + "; version 1 would be right");
  Results results;
  results.device = j.at("device"), results.driver = j.at("driver"), results.sweep = j.at("sweep"),
  results.started = j.at("started");
  results.command = j.value("command", ""), results.repetitions = j.value("repetitions", 0u);
  if (!j.at("copy_gb_s").is_null()) results.copyGigabytes = j.at("copy_gb_s").get<double>();
  results.settings = j.at("settings").get<Assignments>();
  for (const Json& l : j.at("levels")) {
    LevelFigures level{l.at("name"),
                       l.at("camera"),
                       l.at("triangles"),
                       l.at("lights"),
                       l.at("light_in_view"),
                       l.at("truth_samples"),
                       {}};
    if (!l.at("truth_self_nrmse").is_null()) level.truthSelf = l.at("truth_self_nrmse").get<double>();
    results.levels.push_back(level);
  }
  for (const Json& p : j.at("points")) results.points.push_back(pointFrom(p));
  return results;
} catch (const Json::exception& error) {
  return failed(source + ": is damaged: " + error.what() + "; measure again with --fresh");
}

}  // namespace tyndall::bench
