// The program `tyndall`: reads the command line, runs one command, turns its Result into an exit status.
// 0 done; 1 it failed; 2 the call was wrong. A failure is one line on stderr.
#include <cstdio>
#include <exception>
#include <new>

#include "app/print.hpp"
#include "base/process.hpp"
#include "commands.hpp"
#include "settings.hpp"

namespace tyndall::app {
namespace {

Result<void> run(const Options& options) {
  struct Visitor {
    Result<void> operator()(const RenderOptions& o) { return runRender(o); }
    Result<void> operator()(const TruthOptions& o) { return runTruth(o); }
    Result<void> operator()(const DescribeOptions& o) { return runDescribe(o); }
    Result<void> operator()(const LevelsOptions& o) { return runLevels(o); }
    Result<void> operator()(const EditOptions& o) { return runEdit(o); }
    Result<void> operator()(const BenchOptions& o) { return runBench(o); }
    Result<void> operator()(const TextOptions& o) { return print(o.text); }
    Result<void> operator()(const TuneOptions& o) { return runTune(o); }
  };
  return std::visit(Visitor{}, options);
}

int exitStatus(const Error& error) {
  if (error.kind == ErrorKind::kUnread) return 1;
  std::fprintf(stderr, "tyndall: %s\n", oneLine(error.message).c_str());
  return error.kind == ErrorKind::kBadCall ? 2 : 1;
}

}  // namespace
}  // namespace tyndall::app

int main(int argc, char** argv) try {
  using namespace tyndall::app;
  tyndall::prepareProcess();
  auto options = readOptions(argc, argv);
  if (!options) return exitStatus(options.error());
  auto done = run(*options);
  return done ? 0 : exitStatus(done.error());
} catch (const std::bad_alloc&) {
  std::fputs("tyndall: out of memory; a smaller --size or level is needed\n", stderr);
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "tyndall: unexpected: %s\n", tyndall::app::oneLine(error.what()).c_str());
  return 1;
}
