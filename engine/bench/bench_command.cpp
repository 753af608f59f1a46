// tyndall bench: which sweep, which levels, where the results go; progress; going on after an interruption.
#include "app/bench_options.hpp"

#include <csignal>
#include <cstdio>
#include <ctime>

#include <unistd.h>

#include "app/catalogue.hpp"
#include "app/level.hpp"
#include "app/outputs.hpp"
#include "app/print.hpp"
#include "base/file.hpp"
#include "base/file_set.hpp"
#include "bench/campaign.hpp"
#include "bench/report.hpp"

namespace tyndall::bench {
namespace {

constexpr const char* kFiles[] = {"results.json", "results.csv", "report.html"};

volatile std::sig_atomic_t interrupted = 0;
void interrupt(int) { interrupted = 1; }

std::string now() {
  const std::time_t t = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&t, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

double seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// One line that is written over on a terminal; elsewhere a line a view.
class Progress {
 public:
  explicit Progress(std::size_t views) : views_(views), terminal_(::isatty(STDERR_FILENO) != 0), start_(seconds()) {}
  void begin(std::size_t view, const std::string& name) {
    view_ = view, name_ = name;
    if (!terminal_) std::fprintf(stderr, "tyndall: bench: %s (view %zu of %zu)\n", name.c_str(), view + 1, views_);
  }
  bool tell(const std::string& what, std::size_t done, std::size_t all) {
    if (terminal_) {
      const double share = (static_cast<double>(view_) + static_cast<double>(done) / static_cast<double>(all)) /
                           static_cast<double>(views_);
      const double passed = seconds() - start_;
      char left[48] = "";
      if (share > 0.01)
        std::snprintf(left, sizeof left, ", about %.0f min left", passed / share * (1 - share) / 60 + 0.5);
      std::fprintf(stderr, "\r\033[Ktyndall: bench: %s (view %zu of %zu), %s %zu/%zu%s", name_.c_str(), view_ + 1,
                   views_, what.c_str(), done, all, left);
    }
    return interrupted == 0;
  }
  ~Progress() {
    if (terminal_) std::fputs("\r\033[K", stderr);
  }

 private:
  std::size_t views_, view_ = 0;
  bool terminal_;
  double start_;
  std::string name_;
};

Result<Results> readFileOfResults(const std::filesystem::path& path) {
  auto text = readText(path, 1u << 30);
  if (!text) return text.error();
  return readResults(*text, path.string());
}

Result<void> writeReport(const std::string& json, const std::filesystem::path& path) {
  auto html = reportHtml(json);
  if (!html) return failed("the report: " + html.error().message);
  return writeTextAtomically(path, *html);
}

/// All three of one state of the results, or those of the state before.
Result<void> writeAll(const Results& results, const std::filesystem::path& folder) {
  std::string json = resultsJson(results);
  auto html = reportHtml(json);
  if (!html) return failed("the report: " + html.error().message);
  const std::string texts[] = {std::move(json), resultsCsv(results), html.take()};
  static_assert(std::size(texts) == std::size(kFiles));
  FileSet files;
  for (std::size_t i = 0; i < std::size(kFiles); ++i) {
    const char* name = kFiles[i];
    const auto temporary = files.stage(folder / name, (folder / name).string());
    if (!temporary) return temporary.error();
    if (auto done = writeTextAtomically(*temporary, texts[i]); !done)
      return Error{(folder / name).string() + ": " + done.error().message, done.error().kind};
  }
  return files.place();
}

Result<void> compare(const std::vector<std::filesystem::path>& files) {
  if (files.size() != 2)
    return badCall("--compare: has " + std::to_string(files.size()) + " files; two results.json would be right");
  auto a = readFileOfResults(files[0]);
  if (!a) return Error{"--compare " + a.error().message, a.error().kind};
  auto b = readFileOfResults(files[1]);
  if (!b) return Error{"--compare " + b.error().message, b.error().kind};
  return app::print("a: " + files[0].string() + ", " + a->device + "\nb: " + files[1].string() + ", " + b->device +
                    "\n" + compareResults(*a, *b));
}

/// Results that lie in the folder and were measured the same way, or new ones.
Result<Results> begin(const app::BenchOptions& options, const std::filesystem::path& folder, const Sweep& sweep,
                      const gpu::DeviceInfo& device) {
  Results results;
  results.device = device.name, results.driver = device.driver, results.sweep = sweep.name, results.started = now(),
  results.settings = sweep.settings, results.repetitions = sweep.repetitions;
  results.command = "tyndall bench";
  for (const std::string& level : options.levels) results.command += " " + level;
  results.command += " --sweep " + options.sweep;
  if (options.size)
    results.command += " --size " + std::to_string(sweep.size.first) + "x" + std::to_string(sweep.size.second);
  if (options.repetitions) results.command += " --repetitions " + std::to_string(sweep.repetitions);
  const auto file = folder / "results.json";
  if (options.fresh || !std::filesystem::exists(file)) return results;
  auto earlier = readFileOfResults(file);
  if (!earlier) return earlier.error();
  if (earlier->device != results.device || earlier->driver != results.driver)
    return failed(file.string() + ": was measured on " + earlier->device + ", " + earlier->driver + ", this is " +
                  results.device + ", " + results.driver +
                  "; another --out, or --fresh to measure everything again, is needed");
  if (earlier->sweep != results.sweep || earlier->settings != results.settings)
    return failed(file.string() +
                  ": is of another sweep or of other common settings; another --out, or --fresh, is needed");
  if (earlier->repetitions != 0 && earlier->repetitions != results.repetitions)
    return failed(file.string() + ": was measured with " + std::to_string(earlier->repetitions) +
                  " repetitions, this call has " + std::to_string(results.repetitions) + "; --repetitions " +
                  std::to_string(earlier->repetitions) + ", another --out, or --fresh, is needed");
  // What failed is tried again.
  std::erase_if(earlier->points, [](const PointFigures& p) { return !p.failure.empty(); });
  return earlier;
}

Result<void> measure(const app::BenchOptions& options) {
  auto sweep = findSweep(options.sweep);
  if (!sweep) return sweep.error();
  if (options.size) sweep->size = *options.size;
  if (options.repetitions) sweep->repetitions = *options.repetitions;
  const std::vector<std::string> levels = !options.levels.empty()  ? options.levels
                                          : !sweep->levels.empty() ? sweep->levels
                                                                   : app::sampleLevels();
  for (const std::string& level : levels)
    if (auto found = app::findLevel(level); !found) return found.error();
  const std::filesystem::path folder =
      options.out.empty() ? std::filesystem::path("out") / "bench" / sweep->name : options.out;
  std::error_code bad;
  std::filesystem::create_directories(folder, bad);
  if (bad) return failed("--out " + folder.string() + ": cannot be made: " + bad.message());
  // Before anything is measured: what would stand in the way of the results, and what they would destroy.
  app::Outputs outputs;
  outputs.protect(options.sweep);
  for (const char* name : kFiles)
    if (auto free = outputs.add("--out", folder / name, std::filesystem::path(name).extension().string()); !free)
      return free;

  auto catalogue = app::Catalogue::load(app::pluginFolder(options.pluginFolder));
  if (!catalogue) return catalogue.error();
  // Settings are checked before a device is opened.
  if (auto planned = pointsOf(*sweep, **catalogue, "", 0, 0); !planned) return planned.error();
  auto stand = Stand::open(catalogue.take(), options.device);
  if (!stand) return stand.error();
  auto results = begin(options, folder, *sweep, (*stand)->session().device().info());
  if (!results) return results.error();
  auto rate = copyRate((*stand)->session());
  if (!rate) return rate.error();
  results->copyGigabytes = *rate * 1e-9;

  const auto earlier = std::signal(SIGINT, interrupt);
  Progress progress(levels.size() * sweep->cameras.size());
  const Watcher watcher{
      [&](const std::string& what, std::size_t done, std::size_t all) { return progress.tell(what, done, all); }};
  std::size_t view = 0;
  Result<void> outcome;
  for (std::size_t l = 0; l < levels.size() && outcome; ++l) {
    for (const std::uint32_t camera : sweep->cameras) {
      progress.begin(view++, levels[l] + " camera " + std::to_string(camera));
      auto level = app::loadLevel(levels[l]);
      if (!level) {
        outcome = level.error();
        break;
      }
      if (camera >= level->cameras(0).size() && camera > 0) {
        std::fprintf(stderr, "tyndall: note: bench: %s has no camera %u; left out\n", levels[l].c_str(), camera);
        continue;
      }
      if (auto set = (*stand)->setLevel(level.take()); !set) {
        outcome = set;
        break;
      }
      const std::uint64_t content = (*stand)->session().level()->contentHash;
      auto planned = pointsOf(*sweep, (*stand)->catalogue(), levels[l], content, camera);
      if (!planned) {
        outcome = planned.error();
        break;
      }
      auto went = measureView(**stand, *sweep, *(*stand)->session().level(), camera, *planned, *results, watcher);
      if (!went) {
        outcome = went.error();
        break;
      }
      if (!*went) {
        outcome = failed("bench: interrupted in " + levels[l] + "; the same call goes on from there");
        break;
      }
      if (auto written = writeAll(*results, folder); !written) {
        outcome = written;
        break;
      }
    }
  }
  std::signal(SIGINT, earlier);
  if (!outcome) return outcome;
  std::string text;
  for (const char* name : kFiles) text += (folder / name).string() + "\n";
  // Hours of measuring that were kept view by view are not taken back because nobody reads where they lie.
  if (auto printed = app::print(text); !printed && printed.error().kind != ErrorKind::kUnread)
    std::fprintf(stderr, "tyndall: warning: bench: %s; the results are kept in %s\n", printed.error().message.c_str(),
                 folder.c_str());
  return {};
}

}  // namespace
}  // namespace tyndall::bench

namespace tyndall::app {

Result<void> runBench(const BenchOptions& options) {
  if (!options.compare.empty()) return bench::compare(options.compare);
  if (!options.report.empty()) {
    auto text = readText(options.report, 1u << 30);
    if (!text) return Error{"--report " + text.error().message, text.error().kind};
    const std::filesystem::path report =
        (options.out.empty() ? options.report.parent_path() : options.out) / "report.html";
    Outputs outputs;
    outputs.protect(options.report);
    if (auto added = outputs.add("--report", report, ".html"); !added) return added;
    return bench::writeReport(*text, report);
  }
  return bench::measure(options);
}

}  // namespace tyndall::app
