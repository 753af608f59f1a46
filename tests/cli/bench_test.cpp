// tyndall bench from end to end, on a small sweep.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "process.hpp"

namespace tyndall::cli {
namespace {

const char* kSweep =
    R"({"size": [64, 36], "error_size": [64, 36], "repetitions": 2, "truth_samples": 32, "every_technique": false,
  "settings": {"shadows.resolution": 256, "volumetrics.columns": 64, "volumetrics.slices": 64, "volumetrics.prefix_scheme": "row"},
  "march": {"volumetrics.technique": "ray_march", "volumetrics.steps": 128},
  "knobs": [{"id": "volumetrics.steps", "values": [8, 64]}, {"id": "volumetrics.levels", "values": [2, 0], "with": {"volumetrics.row_order": "column"}}]})";

using Json = nlohmann::json;

class Bench : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    writeText(folder_ / "small.json", kSweep);
  }
  /// Truths of these tests stay in the test's own folder.
  Environment cache() const { return {{"XDG_CACHE_HOME", (folder_ / "cache").string()}}; }
  const std::vector<std::string> kCall{"bench", "vault", "--sweep", "small.json", "--out", "r"};
};

TEST_F(Bench, MeasuresOnceAndGoesOn) {
  const Outcome first = tyndall(kCall, cache());
  ASSERT_EQ(first.status, 0) << first.err;
  EXPECT_NE(first.out.find("results.json"), std::string::npos);
  const std::string json = readText(folder_ / "r/results.json");
  const Json results = Json::parse(json);
  ASSERT_EQ(results["points"].size(), 4u);
  std::map<std::string, double> errors;
  for (const Json& p : results["points"]) {
    EXPECT_TRUE(p["failed"].is_null()) << p;
    EXPECT_GT(p["volumetrics_ms"]["median"], 0.0);
    EXPECT_EQ(p["volumetrics_ms"]["n"], 2);
    EXPECT_GT(p["memory_bytes"], 0);
    EXPECT_GT(p["shadow_ms"]["median"], 0.0);
    EXPECT_TRUE(p["floor_bytes"].is_null()) << "two lights take turns";
    errors[p["label"]] = p["error"]["truth"]["all"]["nrmse"];
  }
  // More steps, more levels: less error.
  EXPECT_LT(errors.at("steps = 64"), errors.at("steps = 8"));
  EXPECT_LT(errors.at("levels = 0"), errors.at("levels = 2"));
  EXPECT_GT(readText(folder_ / "r/report.html").size(), 10'000u);
  // A line of names, and one a point.
  const std::string csv = readText(folder_ / "r/results.csv");
  EXPECT_EQ(csv.rfind("level,", 0), 0u) << csv;
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), static_cast<std::ptrdiff_t>(results["points"].size()) + 1) << csv;

  // The second call finds everything measured.
  const Outcome second = tyndall(kCall, cache());
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(Json::parse(readText(folder_ / "r/results.json"))["points"], results["points"]);

  auto moreOften = kCall;
  moreOften.insert(moreOften.end(), {"--repetitions", "7"});
  const Outcome mixed = tyndall(moreOften, cache());
  EXPECT_EQ(mixed.status, 1);
  EXPECT_NE(mixed.err.find("7"), std::string::npos) << mixed.err;

  const Outcome ratios = tyndall({"bench", "--compare", "r/results.json", "r/results.json"});
  EXPECT_EQ(ratios.status, 0);
  EXPECT_NE(ratios.out.find("time 1.000, error 1.000"), std::string::npos) << ratios.out;

  // What was measured elsewhere is not mixed with this.
  std::string other = json;
  other.replace(other.find("\"driver\": \""), 11, "\"driver\": \"another ");
  writeText(folder_ / "r/results.json", other);
  const Outcome refused = tyndall(kCall, cache());
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("--fresh"), std::string::npos) << refused.err;
  EXPECT_EQ(readText(folder_ / "r/results.json"), other);
}

TEST_F(Bench, WrongCallsAreRefusedInOneLine) {
  expectRefused({"bench", "hal"}, 2, {"hal", "'hall'"});
  expectRefused({"bench", "--sweep", "quik"}, 2, {"--sweep", "quik", "'quick'"});
  expectRefused({"bench", "--sweep", "none.json"}, 2, {"--sweep", "none.json"});
  expectRefused({"bench", "--repetitions", "0"}, 2, {"--repetitions"});
  expectRefused({"bench", "--size", "64"}, 2, {"--size"});
  expectRefused({"bench", "--sweeep", "quick"}, 2, {"--sweep"});
  expectRefused({"bench", "--compare", "a.json", "b.json"}, 1, {"--compare", "a.json"});
  expectRefused({"bench", "--report", "a.json"}, 1, {"--report", "a.json"});
  writeText(folder_ / "wrong.json", R"({"knobs": [{"id": "volumetrics.steps", "values": [0]}]})");
  expectRefused({"bench", "hall", "--sweep", "wrong.json", "--out", "small.json"}, 1, {"--out", "small.json"});
}

TEST_F(Bench, AnInterruptionLeavesNothingHalfWritten) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (::chdir(folder_.c_str()) != 0) ::_exit(99);
    ::setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    if (!std::freopen("err.txt", "w", stderr) || !std::freopen("out.txt", "w", stdout)) ::_exit(98);
    ::execl(TYNDALL_BIN_DIR "/tyndall", "tyndall", "bench", "vault", "--sweep", "small.json", "--repetitions", "1000",
            "--out", "r", nullptr);
    ::_exit(97);
  }
  // It is at work when its folder is there.
  for (int i = 0; i < 300 && !std::filesystem::exists(folder_ / "r"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  ::kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  if (WIFSIGNALED(status)) {
    EXPECT_EQ(WTERMSIG(status), SIGINT) << "before the handler stood";
  } else {
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_NE(readText(folder_ / "err.txt").find("interrupted"), std::string::npos);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "r/results.json")) << "no view was finished";
  EXPECT_EQ(tyndall(kCall, cache()).status, 0);
}

}  // namespace
}  // namespace tyndall::cli
