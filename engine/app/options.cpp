// The command line by CLI11, which appears in this file only. CLI11 splits arguments; numbers and files are checked
// here and later, so that every refusal is one line that names the option.
#include "options.hpp"

#include <tuple>

#include <CLI/CLI.hpp>

#include "app/values.hpp"
#include "base/file.hpp"

#ifndef TYNDALL_VERSION
#error "TYNDALL_VERSION comes from engine/app/CMakeLists.txt"
#endif

namespace tyndall::app {
namespace {

/// Options as the text they were given as.
struct Given {
  std::string level, camera = "0", size = "1280x720", frames = "1", seconds = "0", samples = "1024";
  std::string pose, preset, plugins, out, scatter, depth, stats, debugView, viewExr, device;
  std::vector<std::string> assignments;
  bool validate = false, json = false;
  std::vector<std::string> levels, compare;
  std::string sweep = "quick", repetitions, report;
  bool fresh = false;
  std::vector<std::string> cameras, holdOut;
  std::string budget, maxError, margin = "0.1", turned = "0", candidates;
  bool noLightViews = false;
};

void addLevel(CLI::App& command, Given& given) {
  command.add_option("LEVEL", given.level, "a sample's name (see: tyndall levels) or a path to a .gltf or .glb file");
}

void addDevice(CLI::App& command, Given& given) {
  command
      .add_option("--device", given.device,
                  "an index, or a part of the name, of a device; instead of $TYNDALL_DEVICE or the best")
      ->type_name("TEXT");
}

void addPluginFolder(CLI::App& command, Given& given) {
  command
      .add_option("--plugin-dir", given.plugins,
                  "folder of the plugins, instead of $TYNDALL_PLUGIN_DIR or plugins/ beside the program")
      ->type_name("DIR");
}

/// One value each time that it is given.
void addRepeatable(CLI::App& command, const char* name, std::vector<std::string>& values, const char* type,
                   const char* doc) {
  command.add_option(name, values, doc)->type_name(type)->expected(1)->take_all()->allow_extra_args(false);
}

void addSettings(CLI::App& command, Given& given) {
  addRepeatable(command, "--set", given.assignments, "id=value",
                "sets a parameter (see: tyndall describe); repeatable, the later wins");
  command.add_option("--preset", given.preset, "parameter values from a file; --set comes after it")
      ->type_name("FILE.json");
  addPluginFolder(command, given);
}

void addView(CLI::App& command, Given& given) {
  command.add_option("--camera", given.camera, "which of the file's perspective cameras, in node order [0]")
      ->type_name("N");
  command
      .add_option("--pose", given.pose,
                  "stands the camera at X,Y,Z (metres) and turns it (degrees; yaw 0 is along -Z and grows to the "
                  "right); the lens stays")
      ->type_name("X,Y,Z,YAW,PITCH");
  command.add_option("--size", given.size, "size of the picture in pixels [1280x720]")->type_name("WxH");
  command.add_option("--time", given.seconds, "time of the level's animations [0]")->type_name("SECONDS");
}

void addRender(CLI::App& command, Given& given) {
  addLevel(command, given);
  addView(command, given);
  addSettings(command, given);
  command
      .add_option("--frames", given.frames,
                  "frames rendered and timed after a warm-up; times are those of the median frame [1]")
      ->type_name("N");
  command.add_option("--out", given.out, "the picture, 8-bit sRGB")->type_name("IMAGE.png");
  command
      .add_option("--scatter", given.scatter,
                  "R,G,B in-scattered radiance before exposure, A transmittance; 32-bit float")
      ->type_name("FILE.exr");
  command.add_option("--depth", given.depth, "distance along each pixel's ray in metres; 32-bit float")
      ->type_name("FILE.exr");
  command.add_option("--stats", given.stats, "times, memory, settings")->type_name("FILE.json");
  command
      .add_option("--debug-view", given.debugView,
                  "shows a view of the insides instead of the picture (see: tyndall describe)")
      ->type_name("NAME");
  command
      .add_option("--view-exr", given.viewExr,
                  "the numbers of the debug view's own image, as a shader reads them; 32-bit float")
      ->type_name("FILE.exr");
  addDevice(command, given);
  command.add_flag("--validate", given.validate,
                   "validation layer with synchronization validation; any message makes the exit status 1");
}

void addTruth(CLI::App& command, Given& given) {
  addLevel(command, given);
  addView(command, given);
  addSettings(command, given);
  command.add_option("--samples", given.samples, "shadow rays per view ray and light [1024]")->type_name("N");
  command.add_option("--out", given.scatter, "R,G,B in-scattered radiance, A transmittance; 32-bit float")
      ->type_name("FILE.exr");
  command.add_option("--depth", given.depth, "distance along each pixel's ray in metres; 32-bit float")
      ->type_name("FILE.exr");
}

void addBench(CLI::App& command, Given& given) {
  command.add_option("LEVEL", given.levels, "samples or paths, instead of the sweep's own levels");
  command
      .add_option("--sweep", given.sweep, "quick, full, papers, scaling, motion, or a file of the same form [quick]")
      ->type_name("NAME|FILE.json");
  command.add_option("--size", given.size, "size of the pictures that are timed, instead of the sweep's")
      ->type_name("WxH");
  command.add_option("--repetitions", given.repetitions, "timed frames of each point, instead of the sweep's")
      ->type_name("N");
  command
      .add_option(
          "--out", given.out,
          "folder of results.json, results.csv and report.html [out/bench/<sweep>]; what it holds is gone on with")
      ->type_name("DIR");
  command.add_flag("--fresh", given.fresh, "measures everything again");
  addDevice(command, given);
  addPluginFolder(command, given);
  command.add_option("--compare", given.compare, "a table of the ratios of two results.json, instead of measuring")
      ->type_name("A.json B.json")
      ->expected(2);
  command.add_option("--report", given.report, "makes the report of a results.json again, instead of measuring")
      ->type_name("RESULTS.json");
}

void addTune(CLI::App& command, Given& given) {
  addLevel(command, given);
  command
      .add_option("--max-error", given.maxError,
                  "finds the cheapest settings whose nRMSE against the ray-traced truth is at most this")
      ->type_name("X");
  command
      .add_option("--budget-ms", given.budget,
                  "finds the least error within so many milliseconds of GPU time in the worst view")
      ->type_name("X");
  addRepeatable(command, "--camera", given.cameras, "N", "a view that counts; repeatable [all of the file's cameras]");
  addRepeatable(command, "--hold-out", given.holdOut, "N",
                "a view that is not searched on, but measured at the end; repeatable");
  command
      .add_option("--turned", given.turned,
                  "so many further views at each camera that is tuned on, turned by 20 degrees to both sides in turn, "
                  "by 40, ... [0]")
      ->type_name("N");
  command.add_flag(
      "--no-light-views", given.noLightViews,
      "no further view, turned to a light, at a camera that sees none: for a game that never looks at its lights");
  command
      .add_option("--candidates", given.candidates,
                  "what to try: a file with the knobs, settings, error_size and truth_samples of a sweep [tune/*.json "
                  "beside the program]")
      ->type_name("FILE.json");
  command
      .add_option("--margin", given.margin,
                  "part of the bound that the search keeps clear of, for the sake of views that it does not see [0.1]")
      ->type_name("X");
  command.add_option("--size", given.size, "size of the pictures that are timed [1280x720]")->type_name("WxH");
  command.add_option("--out", given.out, "the preset; else it goes to standard output")->type_name("PRESET.json");
  addDevice(command, given);
  addPluginFolder(command, given);
}

/// An error for the first argument that nothing took, or success.
Result<void> refuseExtras(const CLI::App& command) {
  const std::vector<std::string> extras = command.remaining();
  if (extras.empty()) return {};
  // The first that looks like an option: what follows it may be its value.
  const auto isOption = [](const std::string& text) { return text.size() > 1 && text[0] == '-'; };
  const auto found = std::find_if(extras.begin(), extras.end(), isOption);
  if (found == extras.end())
    return badCall("'" + extras.front() + "': is one argument too many; see tyndall " + command.get_name() + " --help");
  const std::string name = found->substr(0, found->find('='));
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& text : option->get_lnames()) known.push_back("--" + text);
  const std::string near = nearestName(name, known);
  return badCall(name + ": no such option of 'tyndall " + command.get_name() + "'" +
                 (near.empty() ? "; see tyndall " + command.get_name() + " --help" : "; did you mean " + near + "?"));
}

/// An option that was given with nothing in it.
Result<void> refuseEmpty(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 && option->get_type_size() > 0)
      for (const std::string& text : option->results())
        if (text.empty()) return badCall(option->get_name() + ": is empty; " + option->get_type_name() + " is needed");
  return {};
}

SettingsOptions settingsOf(const Given& given) { return {given.preset, given.assignments, given.plugins}; }

/// Camera, size and time, which render and truth share.
template <class T>
Result<void> readView(const Given& given, T& options) {
  if (given.level.empty())
    return badCall(
        "LEVEL is missing; a sample's name (see: tyndall levels) or a path to a .gltf or .glb file is needed");
  options.level = given.level;
  auto camera = readCount("--camera", given.camera, 0, 1'000'000);
  if (!camera) return camera.error();
  auto size = readSize("--size", given.size);
  if (!size) return size.error();
  auto seconds = readSeconds("--time", given.seconds);
  if (!seconds) return seconds.error();
  if (!given.pose.empty()) {
    auto pose = readPose("--pose", given.pose);
    if (!pose) return pose.error();
    options.pose = *pose;
  }
  options.camera = *camera;
  options.size = *size;
  options.seconds = *seconds;
  options.settings = settingsOf(given);
  return {};
}

Result<Options> readRender(const Given& given) {
  RenderOptions options;
  if (auto view = readView(given, options); !view) return view.error();
  // A million frames is a day's work; more is a slip of the finger.
  auto frames = readCount("--frames", given.frames, 1, 1'000'000);
  if (!frames) return frames.error();
  options.frames = *frames;
  options.picture = given.out, options.scatter = given.scatter, options.depth = given.depth,
  options.stats = given.stats;
  options.debugView = given.debugView, options.device = given.device, options.validate = given.validate;
  options.viewExr = given.viewExr;
  if (!options.viewExr.empty() && options.debugView.empty())
    return badCall("--view-exr: of no view; --debug-view NAME says which (see: tyndall describe)");
  return Options(std::move(options));
}

Result<Options> readTruth(const Given& given) {
  TruthOptions options;
  if (auto view = readView(given, options); !view) return view.error();
  auto samples = readCount("--samples", given.samples, 1, 1'000'000);
  if (!samples) return samples.error();
  options.samples = *samples;
  options.scatter = given.scatter, options.depth = given.depth;
  if (options.scatter.empty()) return badCall("--out is missing; a file name ending in .exr is needed");
  return Options(std::move(options));
}

Result<Options> readBench(const Given& given, bool sized) {
  BenchOptions options;
  if (sized) {
    auto size = readSize("--size", given.size);
    if (!size) return size.error();
    options.size = *size;
  }
  if (!given.repetitions.empty()) {
    auto repetitions = readCount("--repetitions", given.repetitions, 1, 1000);
    if (!repetitions) return repetitions.error();
    options.repetitions = *repetitions;
  }
  options.levels = given.levels, options.sweep = given.sweep, options.out = given.out, options.device = given.device,
  options.pluginFolder = given.plugins;
  options.fresh = given.fresh, options.report = given.report;
  options.compare.assign(given.compare.begin(), given.compare.end());
  return Options(std::move(options));
}

Result<Options> readTune(const Given& given) {
  TuneOptions options;
  if (given.level.empty())
    return badCall(
        "LEVEL is missing; a sample's name (see: tyndall levels) or a path to a .gltf or .glb file is needed");
  options.level = given.level;
  for (const auto& [option, texts, list] :
       {std::tuple{"--camera", &given.cameras, &options.cameras}, {"--hold-out", &given.holdOut, &options.holdOut}})
    for (const std::string& text : *texts) {
      auto camera = readCount(option, text, 0, 1'000'000);
      if (!camera) return camera.error();
      list->push_back(*camera);
    }
  auto margin = readBetween("--margin", given.margin, 0, 0.9);
  if (!margin) return margin.error();
  options.margin = *margin;
  auto turns = readCount("--turned", given.turned, 0, 16);
  if (!turns) return turns.error();
  options.turned = *turns;
  options.lightViews = !given.noLightViews;
  options.candidates = given.candidates;
  auto size = readSize("--size", given.size);
  if (!size) return size.error();
  options.size = *size;
  if (given.budget.empty() == given.maxError.empty())
    return badCall("tune: one of --max-error X and --budget-ms X is needed");
  auto bound =
      given.budget.empty() ? readPositive("--max-error", given.maxError) : readPositive("--budget-ms", given.budget);
  if (!bound) return bound.error();
  (given.budget.empty() ? options.maxError : options.budgetMs) = *bound;
  options.out = given.out, options.device = given.device, options.pluginFolder = given.plugins;
  return Options(std::move(options));
}

}  // namespace

Result<Options> readOptions(int argc, const char* const* argv) try {
  CLI::App app("Tyndall: renders glTF levels with light scattered in the air.", "tyndall");
  app.set_version_flag("--version", "tyndall " TYNDALL_VERSION);
  app.allow_extras();
  Given given;
  CLI::App& render = *app.add_subcommand("render", "renders a level");
  addRender(render, given);
  CLI::App& truth = *app.add_subcommand("truth", "renders a level's in-scattered radiance by ray tracing on the CPU");
  addTruth(truth, given);
  CLI::App& describe = *app.add_subcommand("describe", "lists plugins, techniques, parameters and debug views");
  describe.add_flag("--json", given.json, "as JSON");
  describe.add_option("--plugin-dir", given.plugins, "folder of the plugins")->type_name("DIR");
  describe.add_option("--device", given.device, "device whose debug views are listed")->type_name("TEXT");
  CLI::App& levels = *app.add_subcommand("levels", "lists the sample levels");
  CLI::App& edit = *app.add_subcommand("edit", "starts the editor");
  edit.set_help_flag();
  edit.prefix_command();
  CLI::App& bench = *app.add_subcommand("bench", "measures run time against error");
  addBench(bench, given);
  CLI::App& tune =
      *app.add_subcommand("tune", "searches the cheapest settings under an error, or the best within a time");
  addTune(tune, given);
  for (CLI::App* command : {&render, &truth, &describe, &levels, &bench, &tune}) command->allow_extras();

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Options(TextOptions{app.help()});
  } catch (const CLI::CallForVersion&) {
    return Options(TextOptions{app.version() + "\n"});
  } catch (const CLI::ParseError& error) {
    return badCall(error.what());
  }

  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::string choices = "render, truth, describe, levels, edit, bench or tune is needed";
  if (chosen.empty()) {
    const std::vector<std::string> extras = app.remaining();
    if (extras.empty()) return badCall("no command; " + choices);
    const std::string near = nearestName(extras.front(), names);
    return badCall("'" + extras.front() + "': no such command; " +
                   (near.empty() ? choices : "did you mean '" + near + "'?"));
  }
  const CLI::App& command = *chosen.front();
  if (&command == &edit) return Options(EditOptions{edit.remaining()});
  if (auto extras = refuseExtras(command); !extras) return extras.error();
  if (auto empty = refuseEmpty(command); !empty) return empty.error();
  if (&command == &render) return readRender(given);
  if (&command == &truth) return readTruth(given);
  if (&command == &tune) return readTune(given);
  if (&command == &bench) return readBench(given, bench.get_option("--size")->count() > 0);
  if (&command == &describe) return Options(DescribeOptions{given.json, given.plugins, given.device});
  return Options(LevelsOptions{});
} catch (const CLI::Error& error) {
  return badCall(error.what());
}

}  // namespace tyndall::app
