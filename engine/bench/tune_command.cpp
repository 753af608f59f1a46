// tyndall tune: the fastest settings within a bound on the error, or the best within a budget.
#include <algorithm>
#include <cstdio>

#include "app/catalogue.hpp"
#include "app/level.hpp"
#include "app/outputs.hpp"
#include "app/print.hpp"
#include "base/file.hpp"
#include "bench/statistics.hpp"
#include "tune_search.hpp"

namespace tyndall::app {
namespace {

/// The first and cheap candidates, and those for bounds that they do not meet.
constexpr const char* kFields[] = {"candidates.json", "stronger.json"};

}  // namespace

Result<void> runTune(const TuneOptions& options) {
  auto path = findLevel(options.level);
  if (!path) return path.error();
  Outputs outputs;
  outputs.protect(*path);
  if (!options.candidates.empty()) outputs.protect(options.candidates);
  if (!options.out.empty())
    if (auto added = outputs.add("--out", options.out, ".json"); !added) return added;
  std::vector<bench::Sweep> fields;
  std::vector<std::filesystem::path> files;
  if (options.candidates.empty())
    for (const char* name : kFields) files.push_back(executableFolder() / "tune" / name);
  else
    files.push_back(options.candidates);
  for (const std::filesystem::path& file : files) {
    auto text = readText(file, 1u << 20);
    if (!text) return text.error();
    auto field = bench::readSweep(*text, file.string());
    if (!field) return field.error();
    fields.push_back(field.take());
  }
  auto catalogue = Catalogue::load(pluginFolder(options.pluginFolder));
  if (!catalogue) return catalogue.error();
  auto level = loadLevel(options.level);
  if (!level) return level.error();
  std::vector<std::uint32_t> cameras = options.cameras;
  const auto heldOut = [&](std::uint32_t camera) {
    return std::find(options.holdOut.begin(), options.holdOut.end(), camera) != options.holdOut.end();
  };
  if (cameras.empty())
    for (std::uint32_t i = 0; i < level->cameras(0).size(); ++i)
      if (!heldOut(i)) cameras.push_back(i);
  if (cameras.empty()) return badCall("--hold-out: no camera of '" + options.level + "' is left to tune on");
  for (const auto* list : {&options.cameras, &options.holdOut})
    for (const std::uint32_t camera : *list)
      if (auto chosen = chooseCamera(*level, camera, 0); !chosen) return chosen.error();
  for (const std::uint32_t camera : cameras)
    if (heldOut(camera))
      return badCall("--hold-out: camera " + std::to_string(camera) +
                     " is tuned on, by --camera; a view is one or the other");
  auto stand = bench::Stand::open(catalogue.take(), options.device);
  if (!stand) return stand.error();
  if (auto set = (*stand)->setLevel(level.take()); !set) return set;

  bench::TuneSearch search(**stand, options);
  if (auto chosen = search.chooseViews(cameras); !chosen) return chosen;
  for (const bench::Sweep& field : fields) {
    if (auto done = search.run(field); !done) return done;
    if (search.met()) break;
  }
  const bench::Score score = search.best().score();
  char figures[128];
  int length = std::snprintf(figures, sizeof figures, "nRMSE %.4g", score.error);
  if (const auto limit = bench::predictionLimit(search.best().errors))
    length += std::snprintf(figures + length, sizeof figures - static_cast<std::size_t>(length),
                            " (of unseen views up to %.4g)", *limit);
  if (search.best().timed())
    std::snprintf(figures + length, sizeof figures - static_cast<std::size_t>(length), " in %.4g ms",
                  score.milliseconds);
  if (!search.met())
    return failed("tune: nothing that was tried meets the bound with its margin; nearest is " + std::string(figures) +
                  " with " + search.best().text());
  for (const std::uint32_t camera : options.holdOut)
    if (auto done = search.holdOut(camera); !done) return done;
  for (const auto& [view, held, kindSearched] : search.held()) {
    char text[96];
    std::snprintf(text, sizeof text, "nRMSE %.4g in %.4g ms", held.error, held.milliseconds);
    const char* other = kindSearched ? ""
                        : view.lightOnScreen
                            ? "; a light is on the screen there, and on no view that was searched"
                            : "; no light is on the screen there, and one is on every view that was searched";
    std::fprintf(stderr, "tyndall: %stune: camera %u, which was held out: %s%s%s\n",
                 search.goal().met(held) ? "" : "warning: ", view.camera, text,
                 search.goal().met(held) ? "" : ", outside the bound", other);
  }
  const std::string preset = search.preset();
  if (auto done =
          outputs.write("--out", [&](const std::filesystem::path& p) { return writeTextAtomically(p, preset); });
      !done)
    return done;
  const std::string shown = options.out.empty() ? preset : options.out.string() + "\n";
  if (auto done = outputs.commit([&shown] { return print(shown); }); !done) return done;
  std::fprintf(stderr, "tyndall: tune: %s: %s\n", figures, search.best().text().c_str());
  return {};
}

}  // namespace tyndall::app
