// describe and levels, against the list of ids and defaults that scripts rely on.
#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "process.hpp"

namespace tyndall::cli {
namespace {

using nlohmann::json;
using Describe = CliTest;

std::map<std::string, json> parametersOf(const Outcome& outcome) {
  std::map<std::string, json> parameters;
  const json described = json::parse(outcome.out);
  for (const json& parameter : described.at("parameters")) parameters[parameter.at("id")] = parameter;
  return parameters;
}

TEST_F(Describe, EveryParameterIdOfTheContract) {
  const Outcome outcome = tyndall({"describe", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto parameters = parametersOf(outcome);
  for (const char* id : {"volumetrics.enabled",
                         "volumetrics.technique",
                         "volumetrics.placement",
                         "volumetrics.rectification",
                         "volumetrics.columns",
                         "volumetrics.slices",
                         "volumetrics.basis_count",
                         "volumetrics.bases_per_thread",
                         "volumetrics.regions",
                         "volumetrics.reference_rays",
                         "volumetrics.weights",
                         "volumetrics.overestimation",
                         "volumetrics.precision",
                         "volumetrics.filtered_resampling",
                         "volumetrics.prefix_bounds",
                         "volumetrics.levels",
                         "volumetrics.steps",
                         "volumetrics.jitter",
                         "volumetrics.epipole_block",
                         "volumetrics.reuse",
                         "volumetrics.splits",
                         "volumetrics.slice_spacing",
                         "volumetrics.reference_ray",
                         "volumetrics.basis_evaluation",
                         "volumetrics.prefix_scheme",
                         "volumetrics.near_correction",
                         "volumetrics.march_spacing",
                         "volumetrics.row_filter",
                         "medium.sigma_t",
                         "medium.albedo",
                         "medium.g",
                         "shadows.mode",
                         "shadows.resolution",
                         "shadows.precision",
                         "sky.strength",
                         "view.exposure"}) {
    ASSERT_TRUE(parameters.count(id)) << id;
    const json& parameter = parameters.at(id);
    for (const char* key : {"name", "type", "default", "doc", "owner", "unit"})
      EXPECT_TRUE(parameter.contains(key)) << id << " " << key;
    EXPECT_FALSE(parameter.at("doc").get<std::string>().empty()) << id;
  }
}

TEST_F(Describe, DefaultsChoicesAndRangesOfTheContract) {
  const auto parameters = parametersOf(tyndall({"describe", "--json"}));
  const std::map<std::string, json> defaults = {{"volumetrics.technique", "exact"},
                                                {"volumetrics.placement", "pixel"},
                                                {"volumetrics.rectification", "epipolar"},
                                                {"volumetrics.columns", 1024},
                                                {"volumetrics.slices", 1024},
                                                {"volumetrics.reference_rays", 3},
                                                {"volumetrics.weights", "transmittance"},
                                                {"volumetrics.prefix_bounds", true},
                                                {"volumetrics.levels", 0},
                                                {"volumetrics.reuse", false},
                                                {"volumetrics.enabled", true}};
  for (const auto& [id, value] : defaults) EXPECT_EQ(parameters.at(id).at("default"), value) << id;

  const std::map<std::string, json> choices = {
      {"volumetrics.technique",
       {"none", "ray_march", "min_max", "shadow_volume", "epipolar_sampling", "froxel", "fourier", "moments4",
        "moments6", "exact"}},
      {"volumetrics.placement", {"pixel", "half", "quarter", "epipolar"}},
      {"volumetrics.rectification", {"auto", "linear", "epipolar"}},
      {"volumetrics.weights", {"average", "transmittance"}},
      {"volumetrics.overestimation", {"lower", "half", "upper", "adaptive"}},
      {"volumetrics.precision", {"compact", "standard", "full"}},
      {"volumetrics.slice_spacing", {"azimuth", "border"}},
      {"volumetrics.reference_ray", {"bisectrix", "optimum", "mean"}},
      {"volumetrics.basis_evaluation", {"fused", "separate"}},
      {"volumetrics.prefix_scheme", {"auto", "row", "block", "scan"}},
      {"volumetrics.march_spacing", {"distance", "transmittance"}},
      {"volumetrics.row_filter", {"nearest", "linear", "mipmapped"}},
      {"shadows.mode", {"pcf", "moments", "soft", "variance", "exponential_variance"}},
      {"shadows.precision", {"64", "128"}}};
  for (const auto& [id, value] : choices) EXPECT_EQ(parameters.at(id).at("choices"), value) << id;

  const std::map<std::string, std::pair<int, int>> ranges = {
      {"volumetrics.columns", {64, 4096}},    {"volumetrics.slices", {64, 4096}},
      {"volumetrics.basis_count", {4, 128}},  {"volumetrics.regions", {1, 8}},
      {"volumetrics.reference_rays", {1, 6}}, {"volumetrics.splits", {1, 4}}};
  for (const auto& [id, range] : ranges) {
    EXPECT_EQ(parameters.at(id).at("min"), range.first) << id;
    EXPECT_EQ(parameters.at(id).at("max"), range.second) << id;
  }
}

TEST_F(Describe, TechniquesAndDebugViews) {
  const json described = json::parse(tyndall({"describe", "--json"}).out);
  ASSERT_FALSE(described.at("plugins").empty());
  std::vector<std::string> techniques;
  for (const json& technique : described.at("plugins")[0].at("techniques")) techniques.push_back(technique.at("id"));
  for (const char* id : {"ray_march", "moments4", "moments6"})
    EXPECT_NE(std::find(techniques.begin(), techniques.end(), id), techniques.end()) << id;
  bool engine = false, plugin = false;
  for (const json& view : described.at("debug_views")) (view.at("owner") == "engine" ? engine : plugin) = true;
  EXPECT_TRUE(engine);
  EXPECT_TRUE(plugin);
}

TEST_F(Describe, WorksWithoutADevice) {
  const Outcome outcome = tyndall(
      {"describe", "--json"}, {{"VK_ICD_FILENAMES", "/nonexistent.json"}, {"VK_DRIVER_FILES", "/nonexistent.json"}});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_GT(parametersOf(outcome).size(), 30u);
}

TEST_F(Describe, TextNamesEveryParameter) {
  const Outcome text = tyndall({"describe"});
  ASSERT_EQ(text.status, 0) << text.err;
  for (const auto& [id, parameter] : parametersOf(tyndall({"describe", "--json"})))
    EXPECT_NE(text.out.find(id + " = "), std::string::npos) << id;
}

TEST_F(Describe, LevelsAreTheSamples) {
  const Outcome outcome = tyndall({"levels"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "cage\nforest\nhall\nlattice\nterrain\ntower\ntown\nvault\n");
}

// What is fastest on a device is known once a frame was rendered with it, and described from then on.
TEST_F(Describe, SaysWhatWasMeasured) {
  const Environment own = {{"XDG_CACHE_HOME", folder_.string()}};
  const std::string small = "volumetrics.technique=moments4";
  const auto automatic = [&](const std::string& technique) {
    const json described = json::parse(tyndall({"describe", "--json"}, own).out);
    for (const json& a : described.at("automatic"))
      if (a.at("technique") == technique && a.at("parameter") == "volumetrics.prefix_scheme") return a.at("value");
    ADD_FAILURE() << technique;
    return json();
  };
  EXPECT_TRUE(automatic("moments4").is_null());
  ASSERT_EQ(tyndall({"render", "hall", "--size", "64x36", "--set", small, "--out", "a.png"}, own).status, 0);
  const json found = automatic("moments4");
  EXPECT_TRUE(found == "row" || found == "block" || found == "scan") << found;
  for (const char* other : {"moments6", "fourier"})
    EXPECT_TRUE(automatic(other).is_null()) << other << ": another kernel, not measured";
  EXPECT_NE(
      tyndall({"describe"}, own).out.find("moments4: volumetrics.prefix_scheme=auto is " + found.get<std::string>()),
      std::string::npos);
}

TEST_F(Describe, HelpAndVersion) {
  EXPECT_EQ(tyndall({"--help"}).status, 0);
  const Outcome help = tyndall({"render", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("--debug-view"), std::string::npos);
  EXPECT_EQ(help.err, "");
  EXPECT_EQ(tyndall({"--version"}).out.rfind("tyndall ", 0), 0u);
}

}  // namespace
}  // namespace tyndall::cli
