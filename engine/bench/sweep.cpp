// Sweeps from JSON; the only file that knows their keys.
#include "bench/sweep.hpp"

#include <algorithm>
#include <functional>

#include <nlohmann/json.hpp>

#include "base/file.hpp"
#include "base/json_shape.hpp"

namespace tyndall::bench {
namespace {

using Json = nlohmann::json;

/// Thrown inside this file, caught by readSweep.
struct Wrong {
  std::string what;
};

[[noreturn]] void refuse(const std::string& where, const std::string& is, const std::string& right) {
  throw Wrong{where + " is " + is + "; " + right + " would be right"};
}

std::string shown(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

using Readers = std::map<std::string, std::function<void(const Json&, const std::string&)>>;

void readObject(const Json& json, const std::string& where, const Readers& readers) {
  if (!json.is_object()) refuse(where.empty() ? "the file" : where, shown(json), "an object");
  std::vector<std::string> names;
  for (const auto& [name, reader] : readers) names.push_back(name);
  for (const auto& [key, value] : json.items()) {
    const std::string path = where.empty() ? key : where + "." + key;
    const auto found = readers.find(key);
    if (found == readers.end()) {
      const std::string near = nearestName(key, names);
      throw Wrong{path + ": no such key" + (near.empty() ? "" : "; did you mean '" + near + "'?")};
    }
    found->second(value, path);
  }
}

std::string textOf(const Json& json, const std::string& where) {
  if (!json.is_string() || json.get<std::string>().empty()) refuse(where, shown(json), "a text");
  return json.get<std::string>();
}

double numberOf(const Json& json, const std::string& where, int least, int most) {
  if (!json.is_number() || !(json.get<double>() >= least && json.get<double>() <= most))
    refuse(where, shown(json), "a number from " + std::to_string(least) + " to " + std::to_string(most));
  return json.get<double>();
}

std::uint32_t countOf(const Json& json, const std::string& where, std::uint32_t least, std::uint32_t most) {
  if (!json.is_number_integer() || json.get<std::int64_t>() < least || json.get<std::int64_t>() > most)
    refuse(where, shown(json), "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return json.get<std::uint32_t>();
}

bool boolOf(const Json& json, const std::string& where) {
  if (!json.is_boolean()) refuse(where, shown(json), "true or false");
  return json.get<bool>();
}

template <class T, class Read>
std::vector<T> listOf(const Json& json, const std::string& where, Read read) {
  if (!json.is_array() || json.empty()) refuse(where, shown(json), "a list that is not empty");
  std::vector<T> list;
  for (std::size_t i = 0; i < json.size(); ++i) list.push_back(read(json[i], where + "[" + std::to_string(i) + "]"));
  return list;
}

std::string valueOf(const Json& json, const std::string& where) {
  if (json.is_string()) return json.get<std::string>();
  if (!json.is_number() && !json.is_boolean()) refuse(where, shown(json), "a number, a text, true or false");
  return json.dump();
}

Assignments assignmentsOf(const Json& json, const std::string& where) {
  if (!json.is_object()) refuse(where, shown(json), "an object of parameter ids");
  Assignments assignments;
  for (const auto& [id, value] : json.items()) assignments[id] = valueOf(value, where + "." + id);
  return assignments;
}

Size sizeOf(const Json& json, const std::string& where) {
  if (!json.is_array() || json.size() != 2) refuse(where, shown(json), "[width, height]");
  return {countOf(json[0], where + "[0]", 8, 16384), countOf(json[1], where + "[1]", 8, 16384)};
}

std::vector<std::string> plotsOf(const Json& json, const std::string& where) {
  static const std::vector<std::string> known = {"error_time", "knob",      "resolution", "map",
                                                 "lights",     "triangles", "motion",     "papers"};
  return listOf<std::string>(json, where, [](const Json& j, const std::string& w) {
    const std::string plot = textOf(j, w);
    if (std::find(known.begin(), known.end(), plot) == known.end()) {
      std::string list;
      for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
      refuse(w, shown(j), "one of " + list);
    }
    return plot;
  });
}

Knob knobOf(const Json& json, const std::string& where) {
  Knob knob;
  knob.plots = {"error_time", "knob"};
  readObject(
      json, where,
      {{"id", [&](const Json& j, const std::string& w) { knob.id = textOf(j, w); }},
       {"values", [&](const Json& j, const std::string& w) { knob.values = listOf<std::string>(j, w, valueOf); }},
       {"together", [&](const Json& j, const std::string& w) { knob.together = listOf<std::string>(j, w, textOf); }},
       {"with", [&](const Json& j, const std::string& w) { knob.with = assignmentsOf(j, w); }},
       {"plots", [&](const Json& j, const std::string& w) { knob.plots = plotsOf(j, w); }}});
  if (knob.id.empty() || knob.values.empty()) throw Wrong{where + ": 'id' and 'values' are needed"};
  return knob;
}

PaperFigure paperOf(const Json& json, const std::string& where) {
  PaperFigure paper;
  readObject(json, where,
             {{"paper", [&](const Json& j, const std::string& w) { paper.paper = textOf(j, w); }},
              {"table", [&](const Json& j, const std::string& w) { paper.table = textOf(j, w); }},
              {"row", [&](const Json& j, const std::string& w) { paper.row = textOf(j, w); }},
              {"ms", [&](const Json& j, const std::string& w) { paper.milliseconds = numberOf(j, w, 0, 1'000'000); }},
              {"ratio", [&](const Json& j, const std::string& w) { paper.ratio = numberOf(j, w, 0, 1'000'000); }}});
  if (paper.paper.empty() || paper.table.empty() || paper.row.empty())
    throw Wrong{where + ": 'paper', 'table' and 'row' are needed"};
  return paper;
}

Single singleOf(const Json& json, const std::string& where) {
  Single single;
  single.plots = {"error_time"};
  readObject(json, where,
             {{"series", [&](const Json& j, const std::string& w) { single.series = textOf(j, w); }},
              {"label", [&](const Json& j, const std::string& w) { single.label = textOf(j, w); }},
              {"settings", [&](const Json& j, const std::string& w) { single.settings = assignmentsOf(j, w); }},
              {"plots", [&](const Json& j, const std::string& w) { single.plots = plotsOf(j, w); }},
              {"paper", [&](const Json& j, const std::string& w) { single.paper = paperOf(j, w); }},
              {"baseline", [&](const Json& j, const std::string& w) { single.baseline = boolOf(j, w); }}});
  if (single.series.empty() || single.label.empty() || single.settings.empty())
    throw Wrong{where + ": 'series', 'label' and 'settings' are needed"};
  return single;
}

Motion motionOf(const Json& json, const std::string& where) {
  Motion motion;
  readObject(
      json, where,
      {{"frames", [&](const Json& j, const std::string& w) { motion.frames = countOf(j, w, 2, 10'000); }},
       {"turn_degrees", [&](const Json& j, const std::string& w) { motion.turn = numberOf(j, w, -360'000, 360'000); }},
       {"seconds", [&](const Json& j, const std::string& w) { motion.seconds = numberOf(j, w, -1e6, 1'000'000); }}});
  if (motion.frames == 0) throw Wrong{where + ": 'frames' is needed"};
  return motion;
}

void readInto(Sweep& sweep, const Json& json) {
  const auto text = [](const Json& j, const std::string& w) { return textOf(j, w); };
  readObject(
      json, "",
      {{"doc", [&](const Json& j, const std::string& w) { sweep.doc = textOf(j, w); }},
       {"levels", [&](const Json& j, const std::string& w) { sweep.levels = listOf<std::string>(j, w, text); }},
       {"cameras",
        [&](const Json& j, const std::string& w) {
          sweep.cameras = listOf<std::uint32_t>(
              j, w, [](const Json& v, const std::string& at) { return countOf(v, at, 0, 1'000'000); });
        }},
       {"size", [&](const Json& j, const std::string& w) { sweep.size = sizeOf(j, w); }},
       {"error_size", [&](const Json& j, const std::string& w) { sweep.errorSize = sizeOf(j, w); }},
       {"repetitions", [&](const Json& j, const std::string& w) { sweep.repetitions = countOf(j, w, 1, 1000); }},
       {"seconds_per_point",
        [&](const Json& j, const std::string& w) { sweep.secondsPerPoint = numberOf(j, w, 0, 1'000'000); }},
       {"truth_samples",
        [&](const Json& j, const std::string& w) { sweep.truthSamples = countOf(j, w, 2, 1'000'000); }},
       {"settings", [&](const Json& j, const std::string& w) { sweep.settings = assignmentsOf(j, w); }},
       {"march", [&](const Json& j, const std::string& w) { sweep.march = assignmentsOf(j, w); }},
       {"every_technique", [&](const Json& j, const std::string& w) { sweep.everyTechnique = boolOf(j, w); }},
       {"knobs", [&](const Json& j, const std::string& w) { sweep.knobs = listOf<Knob>(j, w, knobOf); }},
       {"resolutions", [&](const Json& j, const std::string& w) { sweep.resolutions = listOf<Size>(j, w, sizeOf); }},
       {"points", [&](const Json& j, const std::string& w) { sweep.singles = listOf<Single>(j, w, singleOf); }},
       {"motion", [&](const Json& j, const std::string& w) { sweep.motion = motionOf(j, w); }}});
}

std::filesystem::path sweepFolder() { return executableFolder() / "sweeps"; }

}  // namespace

Result<Sweep> readSweep(const std::string& text, const std::string& source) try {
  Sweep sweep;
  sweep.name = std::filesystem::path(source).stem().string();
  if (const std::string problem = jsonShapeProblem(text); !problem.empty())
    return badCall(source + ": its JSON " + problem + "; a sweep nests 5");
  readInto(sweep, Json::parse(text));
  return sweep;
} catch (const Wrong& wrong) {
  return badCall(source + ": " + wrong.what);
} catch (const Json::exception& error) {
  return badCall(source + ": is no JSON: " + error.what());
}

std::vector<std::string> sweepNames() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(sweepFolder(), none))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<Sweep> findSweep(const std::string& nameOrPath) {
  std::filesystem::path path = nameOrPath;
  if (!nameOrPath.ends_with(".json")) {
    const std::vector<std::string> names = sweepNames();
    if (std::find(names.begin(), names.end(), nameOrPath) == names.end()) {
      std::string list;
      for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
      const std::string near = nearestName(nameOrPath, names);
      return badCall("--sweep '" + nameOrPath + "': no such sweep" +
                     (near.empty() ? "" : ", did you mean '" + near + "'?") + "; there are " + list +
                     ", or give a path ending in .json");
    }
    path = sweepFolder() / (nameOrPath + ".json");
  }
  auto text = readText(path, 1u << 20);
  if (!text) return Error{"--sweep " + text.error().message, ErrorKind::kBadCall};
  return readSweep(*text, path.string());
}

}  // namespace tyndall::bench
