#include "options.hpp"

#include <algorithm>
#include <functional>

#include "app/level.hpp"
#include "app/presets.hpp"
#include "app/values.hpp"
#include "base/file.hpp"

namespace tyndall::editor {
namespace {

/// An option that takes a value.
struct Valued {
  const char* name;
  std::function<Result<void>(Options&, const std::string&)> read;
};

template <class T>
Result<void> put(T& field, Result<T> value) {
  if (!value) return value.error();
  field = value.take();
  return {};
}

const std::vector<Valued>& valued() {
  // Files are checked where they are opened; numbers here.
  static const std::vector<Valued> options = {
      {"--camera",
       [](Options& o, const std::string& t) { return put(o.camera, app::readCount("--camera", t, 0, 1'000'000)); }},
      {"--size", [](Options& o, const std::string& t) { return put(o.size, app::readSize("--size", t)); }},
      {"--frames",
       [](Options& o, const std::string& t) { return put(o.frames, app::readCount("--frames", t, 1, 1'000'000)); }},
      {"--time", [](Options& o, const std::string& t) { return put(o.seconds, app::readSeconds("--time", t)); }},
      {"--set", [](Options& o, const std::string& t) { return o.assignments.push_back(t), Result<void>(); }},
      {"--preset", [](Options& o, const std::string& t) { return o.preset = t, Result<void>(); }},
      {"--plugin-dir", [](Options& o, const std::string& t) { return o.pluginFolder = t, Result<void>(); }},
      {"--screenshot", [](Options& o, const std::string& t) { return o.screenshot = t, Result<void>(); }},
      {"--print-state", [](Options& o, const std::string& t) { return o.state = t, Result<void>(); }},
      {"--settings", [](Options& o, const std::string& t) { return o.settings = t, Result<void>(); }},
      {"--stress",
       [](Options& o, const std::string& t) { return put(o.stress, app::readCount("--stress", t, 1, 1'000'000)); }},
      {"--seed",
       [](Options& o, const std::string& t) { return put(o.seed, app::readCount("--seed", t, 0, 0xffffffff)); }},
      {"--device", [](Options& o, const std::string& t) { return o.device = t, Result<void>(); }},
  };
  return options;
}

Error unknownOption(const std::string& name) {
  std::vector<std::string> known{"--validate", "--help"};
  for (const Valued& option : valued()) known.push_back(option.name);
  const std::string near = nearestName(name, known);
  return badCall(name + ": no such option" +
                 (near.empty() ? "; see tyndall-editor --help" : "; did you mean " + near + "?"));
}

}  // namespace

const char* helpText() {
  return "usage: tyndall-editor [LEVEL] [option...]\n"
         "  LEVEL                a sample's name (see: tyndall levels) or a path to a .gltf or .glb file [hall, else "
         "the first sample]\n"
         "  --camera N           which of the file's perspective cameras, in node order [0]\n"
         "  --size WxH           size of the window in pixels [1280x720]\n"
         "  --time SECONDS       time of the level's animations at the start [0]\n"
         "  --set id=value       sets a parameter (see: tyndall describe); repeatable, the later wins\n"
         "  --preset FILE.json   parameter values from a file; --set comes after it\n"
         "  --plugin-dir DIR     folder of the plugins, instead of $TYNDALL_PLUGIN_DIR or plugins/ beside the program\n"
         "  --frames N           ends after N frames\n"
         "  --screenshot FILE.png  writes the last frame shown, the whole window\n"
         "  --print-state FILE.json  keeps a file with camera, parameters and places of the widgets up to date\n"
         "  --settings FILE      what is remembered between runs, instead of $XDG_CONFIG_HOME/tyndall/editor.json or "
         "~/.config/tyndall/editor.json\n"
         "  --stress N           N steps of random use in place of a user's: parameters, sizes, levels, views, "
         "reloads, faults; then a report\n"
         "  --seed S             another random use [1]\n"
         "  --device TEXT        an index, or a part of the name, of a device; instead of $TYNDALL_DEVICE or the best\n"
         "  --validate           validation layer with synchronization validation; any message makes the exit status "
         "1\n";
}

Result<Options> readOptions(int argc, const char* const* argv) {
  Options options;
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.empty() || word[0] != '-') {
      if (word.empty()) return badCall("LEVEL: is empty; a sample's name or a path to a .gltf or .glb file is needed");
      if (!options.level.empty()) return badCall("'" + word + "': is one argument too many; see tyndall-editor --help");
      options.level = word;
      continue;
    }
    if (word == "--validate") {
      options.validate = true;
      continue;
    }
    if (word == "--help" || word == "-h") {
      options.help = true;
      return options;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const Valued* found = nullptr;
    for (const Valued& option : valued())
      if (name == option.name) found = &option;
    if (!found) return unknownOption(name);
    if (equals == std::string::npos && i + 1 == words.size())
      return badCall(name + ": a value is missing; see tyndall-editor --help");
    const std::string text = equals == std::string::npos ? words[++i] : word.substr(equals + 1);
    if (text.empty()) return badCall(name + ": is empty; see tyndall-editor --help");
    if (auto read = found->read(options, text); !read) return read.error();
  }
  if (options.level.empty()) {
    const std::vector<std::string> samples = app::sampleLevels();
    if (samples.empty())
      return badCall("LEVEL is missing and there are no sample levels; a path to a .gltf or .glb file is needed");
    // Every technique has something to show in the hall, but not in a room that only lamps light.
    const bool hall = std::find(samples.begin(), samples.end(), "hall") != samples.end();
    options.level = hall ? "hall" : samples.front();
  }
  return options;
}

Result<std::unique_ptr<app::Catalogue>> loadCatalogue(const Options& options) {
  auto catalogue = app::Catalogue::load(app::pluginFolder(options.pluginFolder));
  if (!catalogue) return catalogue;
  params::Table& table = (*catalogue)->table();
  if (!options.preset.empty()) {
    auto file = app::findPreset(options.preset);
    if (!file) return file.error();
    auto text = readText(*file, 1u << 20);  // a preset is a page of text; 1 MiB is generous
    if (!text) return Error{"--preset " + text.error().message, text.error().kind};
    if (auto read = table.readPreset(*text, file->string()); !read)
      return Error{"--preset " + read.error().message, read.error().kind};
  }
  for (const std::string& assignment : options.assignments)
    if (auto set = table.setAssignment(assignment); !set)
      return Error{"--set " + set.error().message, set.error().kind};
  return catalogue;
}

}  // namespace tyndall::editor
