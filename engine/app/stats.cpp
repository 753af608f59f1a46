// JSON by nlohmann_json, which appears in this file only. Key order is kept: people read these files too.
#include "stats.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "app/median.hpp"
#include "app/memory.hpp"

namespace tyndall::app {
namespace {

using Json = nlohmann::ordered_json;

/// A parameter's value in JSON's own type.
Json valueOf(const params::Parameter& parameter, double value) {
  switch (parameter.type) {
    case params::Type::kBool: return value != 0;
    case params::Type::kInt: return static_cast<std::int64_t>(value);
    case params::Type::kFloat: return value;
    case params::Type::kEnum: return params::toText(parameter, value);
  }
  return nullptr;
}

const char* typeName(params::Type type) {
  switch (type) {
    case params::Type::kBool: return "bool";
    case params::Type::kInt: return "int";
    case params::Type::kFloat: return "float";
    case params::Type::kEnum: return "enum";
  }
  return "";
}

/// Values that the table knows and refuses until they are built.
Json notBuilt(const params::Parameter& parameter) {
  Json list = Json::array();
  for (std::size_t i = 0; i < parameter.built.size(); ++i) {
    if (parameter.built[i]) continue;
    if (parameter.type == params::Type::kEnum)
      list.push_back(parameter.choices[i]);
    else
      list.push_back(i == 1);
  }
  return list;
}

Json parameterJson(const params::Parameter& parameter) {
  Json j;
  j["id"] = parameter.id;
  j["name"] = parameter.name;
  j["owner"] = parameter.owner;
  j["type"] = typeName(parameter.type);
  j["default"] = valueOf(parameter, parameter.defaultValue);
  if (parameter.type == params::Type::kInt || parameter.type == params::Type::kFloat) {
    j["min"] = valueOf(parameter, parameter.min);
    j["max"] = valueOf(parameter, parameter.max);
    j["built_min"] = valueOf(parameter, parameter.builtMin);
    j["built_max"] = valueOf(parameter, parameter.builtMax);
  }
  if (parameter.type == params::Type::kEnum) j["choices"] = parameter.choices;
  j["not_built"] = notBuilt(parameter);
  j["unit"] = parameter.unit;
  j["structural"] = parameter.structural;
  j["doc"] = parameter.doc;
  return j;
}

/// Names come from files and drivers and need not be UTF-8; dump() must not throw over them.
std::string dump(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

double ownedMs(const RenderRun& run, const std::string& owner) {
  double total = 0;
  for (const render::PassTime& pass : run.passes)
    if (pass.owner == owner) total += pass.milliseconds;
  return total;
}

}  // namespace

std::string statsJson(const RenderOptions& options, Session& session, const RenderRun& run,
                      const std::vector<std::string>& notes) {
  const Catalogue& catalogue = session.catalogue();
  Json j;
  j["device"] = session.device().info().name;
  j["driver"] = session.device().info().driver;
  j["level"] = options.level;
  j["camera"] = options.camera;
  if (options.pose) j["pose"] = poseText(*options.pose);
  j["size"] = {options.size.first, options.size.second};
  j["frames"] = options.frames;
  j["gpu_ms"] = totalMs(run.passes);
  j["passes"] = Json::array();
  for (const render::PassTime& pass : run.passes)
    j["passes"].push_back({{"name", pass.name}, {"owner", pass.owner}, {"gpu_ms", pass.milliseconds}});
  // A light's own time is that of its passes; its memory is what they touch, in turn with the other lights.
  Json lights = Json::array();
  const std::vector<std::uint64_t> bytes = session.effect().lightMemoryBytes();
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    double ms = 0;
    for (const render::PassTime& pass : run.passes)
      if (pass.owner == catalogue.effectPlugin().id() && pass.name.ends_with(" [light " + std::to_string(i) + "]"))
        ms += pass.milliseconds;
    lights.push_back({{"light", i}, {"gpu_ms", ms}, {"memory_bytes", bytes[i]}});
  }
  Json skipped = Json::object();
  for (const auto& [reason, count] : session.effect().counters()) skipped[reason] = count;
  j["volumetrics"] = {{"technique", catalogue.techniqueName()},
                      {"gpu_ms", ownedMs(run, catalogue.effectPlugin().id())},
                      {"memory_bytes", run.effectBytes},
                      {"lights", lights},
                      {"skipped", skipped}};
  Json resolved = Json::object();
  for (const auto& [id, value] : session.effect().resolved()) resolved[id] = value;
  j["resolved"] = resolved;
  static constexpr const char* kSources[] = {"automatic", "level", "fixed"};
  j["exposure"] = {{"source", kSources[static_cast<int>(session.exposureSource())]},
                   {"factor", session.exposureFactor()}};
  j["unused_settings"] = catalogue.unusedSettings();
  j["memory"] = {{"device_bytes", run.deviceBytes},
                 {"transient_bytes", run.transientBytes},
                 {"kept", Json::array()},
                 {"passing", Json::array()}};
  for (const ResourceMemory& m : keptMemory(session.device()))
    j["memory"]["kept"].push_back({{"name", m.name}, {"what", m.what}, {"bytes", m.bytes}});
  for (const ResourceMemory& m : passingMemory(session))
    j["memory"]["passing"].push_back({{"name", m.name},
                                      {"owner", m.owner},
                                      {"what", m.what},
                                      {"bytes", m.bytes},
                                      {"first_pass", m.firstPass},
                                      {"last_pass", m.lastPass}});
  j["notes"] = notes;
  j["settings"] = Json::object();
  for (const params::Parameter& parameter : catalogue.table().parameters())
    j["settings"][parameter.id] = valueOf(parameter, catalogue.table().value(parameter.id));
  return dump(j);
}

std::string describeJson(const Catalogue& catalogue, const std::vector<DebugViewText>& views,
                         const std::vector<AutomaticText>& automatics) {
  Json j;
  j["plugins"] = Json::array();
  for (const auto& plugin : catalogue.plugins()) {
    Json techniques = Json::array();
    for (const host::TechniqueInfo& t : plugin->techniques())
      techniques.push_back({{"id", t.id}, {"name", t.name}, {"doc", t.doc}, {"reads", t.reads}});
    j["plugins"].push_back({{"id", plugin->id()},
                            {"name", plugin->name()},
                            {"version", plugin->version()},
                            {"doc", plugin->doc()},
                            {"path", plugin->path().string()},
                            {"techniques", techniques}});
  }
  j["parameters"] = Json::array();
  for (const params::Parameter& parameter : catalogue.table().parameters())
    j["parameters"].push_back(parameterJson(parameter));
  j["debug_views"] = Json::array();
  for (const DebugViewText& view : views)
    j["debug_views"].push_back(
        {{"name", view.name}, {"owner", view.owner}, {"doc", view.doc}, {"techniques", view.techniques}});
  j["automatic"] = Json::array();
  for (const AutomaticText& a : automatics)
    j["automatic"].push_back(
        {{"technique", a.technique}, {"parameter", a.parameter}, {"value", a.value.empty() ? Json() : Json(a.value)}});
  return dump(j);
}

}  // namespace tyndall::app
