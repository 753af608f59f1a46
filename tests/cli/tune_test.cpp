// tyndall tune from end to end. Every candidate compiles pipelines of its own, which takes minutes on a CPU.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "process.hpp"

namespace tyndall::cli {
namespace {

using Json = nlohmann::json;

class Tune : public CliTest {
 protected:
  /// Truths of these tests stay in the test's own folder.
  Environment cache() const { return {{"XDG_CACHE_HOME", (folder_ / "cache").string()}}; }
};

// The whole way from a bound to a preset, on a small field of candidates.
TEST_F(Tune, WritesAPresetWithItsEvidence) {
  writeText(
      folder_ / "few.json",
      R"({"error_size": [64, 36], "truth_samples": 64, "settings": {"shadows.resolution": 512, "volumetrics.prefix_scheme": "row"},
    "knobs": [{"id": "volumetrics.columns", "values": [64, 256], "together": ["volumetrics.slices"]}, {"id": "volumetrics.reference_rays", "values": [1, 6]},
              {"id": "volumetrics.steps", "values": [2, 64]}, {"id": "volumetrics.basis_count", "values": [8]}]})");
  const std::vector<std::string> call{"tune",   "terrain",    "--max-error", "0.3",          "--camera",
                                      "0",      "--hold-out", "1",           "--candidates", "few.json",
                                      "--size", "64x36",      "--out",       "p.json"};
  const Outcome tuned = tyndall(call, cache());
  ASSERT_EQ(tuned.status, 0) << tuned.err;
  const Json preset = Json::parse(readText(folder_ / "p.json")), evidence = preset["evidence"];
  EXPECT_EQ(evidence["bound"]["max_nrmse"], 0.3);
  EXPECT_LE(evidence["nrmse"], 0.27) << "the margin is a tenth";
  // The camera does not see the sun: a view turned to it is searched on too, and first.
  ASSERT_EQ(evidence["views"].size(), 2u);
  EXPECT_EQ(evidence["views"][0]["light_on_screen"], true);
  EXPECT_NE(evidence["views"][0]["turned_degrees"], 0.0);
  EXPECT_EQ(evidence["views"][1]["light_on_screen"], false);
  EXPECT_EQ(evidence["views"][1]["turned_degrees"], 0.0);
  EXPECT_EQ(evidence["nrmse"],
            std::max(evidence["views"][0]["nrmse"].get<double>(), evidence["views"][1]["nrmse"].get<double>()));
  ASSERT_EQ(evidence["hold_out"].size(), 1u);
  const Json& held = evidence["hold_out"][0];
  EXPECT_EQ(held["camera"], 1);
  EXPECT_EQ(held["met"], held["nrmse"] <= 0.3);
  EXPECT_NE(tuned.err.find("held out"), std::string::npos);
  EXPECT_GT(evidence["candidates_by_round"][0], 10);
  std::string left;
  for (const Json& text : evidence["left_out"]) left += text.get<std::string>() + "\n";
  EXPECT_NE(left.find("volumetrics.levels: kept at"), std::string::npos) << left;
  EXPECT_EQ(left.find("volumetrics.steps: kept"), std::string::npos) << left;
  // Nobody of the last round that meets the bound is cheaper.
  for (const Json& other : evidence["others_of_the_last_round"])
    if (other["nrmse"] <= 0.27) {
      EXPECT_EQ(other["views"], 2) << other;
      EXPECT_GE(other["milliseconds"], evidence["milliseconds"]) << other;
    } else {
      EXPECT_GE(other["views"], 1) << other;
    }

  // Evidence changes nothing: the preset renders what its settings do.
  std::vector<std::string> byPreset{"render", "terrain", "--size", "64x36", "--preset", "p.json", "--scatter", "a.exr"},
      bySettings{"render", "terrain", "--size", "64x36", "--scatter", "b.exr"};
  for (const auto& [id, value] : preset["settings"].items()) {
    bySettings.push_back("--set");
    bySettings.push_back(id + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
  }
  ASSERT_EQ(tyndall(byPreset).status, 0);
  ASSERT_EQ(tyndall(bySettings).status, 0);
  EXPECT_EQ(readText(folder_ / "a.exr"), readText(folder_ / "b.exr"));

  // A bound that nobody meets: nothing is written, and the nearest is named.
  std::vector<std::string> hopeless = call;
  hopeless[3] = "1e-6";
  hopeless.back() = "q.json";
  const Outcome none = tyndall(hopeless, cache());
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("nearest is nRMSE"), std::string::npos) << none.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "q.json"));
}

}  // namespace
}  // namespace tyndall::cli
