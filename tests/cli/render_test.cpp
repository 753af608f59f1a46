// Good calls of render: files, their sizes, and what the stats say.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "image/image_io.hpp"
#include "process.hpp"

namespace tyndall::cli {
namespace {

using nlohmann::json;
using Render = CliTest;

const std::vector<std::string> kSmall = {"render", "hall", "--size", "96x54"};

std::vector<std::string> with(std::vector<std::string> call, const std::vector<std::string>& more) {
  call.insert(call.end(), more.begin(), more.end());
  return call;
}

json statsOf(const std::filesystem::path& folder, const std::vector<std::string>& call) {
  const Outcome outcome = run(folder, with(call, {"--stats", "s.json"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.status == 0 ? json::parse(readText(folder / "s.json")) : json::object();
}

class EachTechnique : public Render {
 protected:
  void givesEveryFileAndTimesThatAddUp(const std::string& technique) const;
};

void EachTechnique::givesEveryFileAndTimesThatAddUp(const std::string& technique) const {
  const Outcome outcome =
      tyndall(with(kSmall, {"--frames", "3", "--set", "volumetrics.technique=" + technique, "--out", "a.png",
                            "--scatter", "s.exr", "--depth", "d.exr", "--stats", "s.json"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(files(), (std::vector<std::string>{"a.png", "d.exr", "s.exr", "s.json"}));

  auto picture = image::readPng(folder_ / "a.png");
  auto scatter = image::readExr(folder_ / "s.exr");
  auto depth = image::readExr(folder_ / "d.exr");
  ASSERT_TRUE(picture && scatter && depth);
  EXPECT_EQ(picture->width, 96u);
  EXPECT_EQ(picture->height, 54u);
  EXPECT_EQ(scatter->channels, 4u);
  EXPECT_EQ(depth->channels, 1u);
  ASSERT_EQ(scatter->values.size(), 96u * 54 * 4);
  ASSERT_EQ(depth->values.size(), 96u * 54);

  const json stats = json::parse(readText(folder_ / "s.json"));
  for (const char* key : {"device", "driver", "level", "camera", "size", "frames", "passes", "volumetrics", "gpu_ms",
                          "settings", "unused_settings", "resolved", "notes", "memory"})
    EXPECT_TRUE(stats.contains(key)) << key;
  // Memory by resource: what is kept is all that there is; what passes shares a part of it, and says from which pass to
  // which.
  const json& memory = stats.at("memory");
  std::uint64_t kept = 0;
  for (const json& resource : memory.at("kept")) kept += resource.at("bytes").get<std::uint64_t>();
  EXPECT_EQ(kept, memory.at("device_bytes"));
  std::uint64_t passing = 0, effects = 0;
  std::set<std::string> ran;
  for (const json& pass : stats.at("passes")) ran.insert(pass.at("name"));
  for (const json& resource : memory.at("passing")) {
    passing += resource.at("bytes").get<std::uint64_t>();
    EXPECT_FALSE(resource.at("what").get<std::string>().empty());
    if (resource.at("owner") != "volumetrics") continue;
    effects += resource.at("bytes").get<std::uint64_t>();
    EXPECT_TRUE(ran.contains(resource.at("first_pass")) || resource.at("first_pass") == "readback") << resource;
  }
  EXPECT_GE(passing, memory.at("transient_bytes").get<std::uint64_t>());
  EXPECT_EQ(effects > 0, technique != "none");
  EXPECT_EQ(stats.at("size"), json({96, 54}));
  EXPECT_EQ(stats.at("frames"), 3);
  double total = 0, owned = 0;
  for (const json& pass : stats.at("passes")) {
    EXPECT_GE(pass.at("gpu_ms").get<double>(), 0) << pass;
    EXPECT_FALSE(pass.at("name").get<std::string>().empty());
    EXPECT_NE(pass.at("owner"), "readback");
    total += pass.at("gpu_ms").get<double>();
    if (pass.at("owner") == "volumetrics") owned += pass.at("gpu_ms").get<double>();
  }
  EXPECT_GT(total, 0);
  EXPECT_NEAR(stats.at("gpu_ms").get<double>(), total, 1e-9 * total);
  const json& volumetrics = stats.at("volumetrics");
  EXPECT_EQ(volumetrics.at("technique"), technique);
  EXPECT_TRUE(volumetrics.at("skipped").is_object());
  EXPECT_NEAR(volumetrics.at("gpu_ms").get<double>(), owned, 1e-9 * total);
  if (technique == "none") {
    EXPECT_EQ(owned, 0);
    for (std::size_t i = 0; i < scatter->values.size(); ++i) ASSERT_EQ(scatter->values[i], i % 4 == 3 ? 1.0f : 0.0f);
  } else {
    EXPECT_GT(owned, 0);
    EXPECT_GT(volumetrics.at("memory_bytes").get<std::uint64_t>(), 96u * 54 * 16 - 1);
    // The hall's only light has all passes that are anyone's.
    ASSERT_EQ(volumetrics.at("lights").size(), 1u);
    const auto& light = volumetrics.at("lights")[0];
    EXPECT_GT(light.at("gpu_ms").get<double>(), 0);
    EXPECT_LE(light.at("gpu_ms").get<double>(), volumetrics.at("gpu_ms").get<double>() * (1 + 1e-9));
    EXPECT_LE(light.at("memory_bytes").get<std::uint64_t>(), volumetrics.at("memory_bytes").get<std::uint64_t>());
    // Alpha is the transmittance over the distance of the depth file, with the default medium.
    const double sigma_t = stats.at("settings").at("medium.sigma_t");
    for (std::size_t i = 0; i < depth->values.size(); i += 97)
      EXPECT_NEAR(scatter->values[4 * i + 3], std::exp(-sigma_t * depth->values[i]), 2e-3) << i;
  }
}

TEST_F(EachTechnique, GivesEveryFileAndTimesThatAddUp) {
  std::vector<std::string> all = techniques();
  all.push_back("none");
  for (const std::string& technique : all) {
    SCOPED_TRACE(technique);
    givesEveryFileAndTimesThatAddUp(technique);
  }
}

TEST_F(Render, StdoutIsATableOfThePassesAndTheFiles) {
  const Outcome outcome = tyndall(with(kSmall, {"--out", "a.png"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* word : {"96x54", "total", "a.png", "volumetrics"})
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
}

TEST_F(Render, TheWholeFrameIsTimedWhateverIsWritten) {
  const auto names = [&](const std::vector<std::string>& more) {
    std::vector<std::string> list;
    const json stats = statsOf(folder_, with(kSmall, more));
    for (const json& pass : stats.at("passes")) list.push_back(pass.at("name"));
    return list;
  };
  const std::vector<std::string> all = names({"--out", "a.png"});
  EXPECT_GE(all.size(), 5u);
  EXPECT_EQ(names({}), all);
  EXPECT_EQ(names({"--scatter", "s.exr"}), all);
}

TEST_F(Render, SettingsInAnyOrderAndTheLaterWins) {
  const std::vector<std::string> one = {
      "--set", "volumetrics.technique=ray_march", "--set", "volumetrics.steps=16", "--set", "medium.g=0.25"};
  const std::vector<std::string> other = {"--set", "medium.g=0.9",         "--set", "medium.g=0.25",
                                          "--set", "volumetrics.steps=16", "--set", "volumetrics.technique=ray_march"};
  const json a = statsOf(folder_, with(kSmall, one)), b = statsOf(folder_, with(kSmall, other));
  EXPECT_EQ(a.at("settings"), b.at("settings"));
  EXPECT_EQ(a.at("settings").at("medium.g"), 0.25);
  EXPECT_EQ(a.at("settings").at("volumetrics.steps"), 16);
}

TEST_F(Render, PresetThenSet) {
  writeText(folder_ / "p.json", R"({"medium.g": 0.1, "medium.albedo": 0.5, "volumetrics.technique": "ray_march"})");
  const json stats = statsOf(folder_, with(kSmall, {"--set", "medium.g=0.2", "--preset", "p.json"}));
  EXPECT_EQ(stats.at("settings").at("medium.g"), 0.2);
  EXPECT_EQ(stats.at("settings").at("medium.albedo"), 0.5);
  EXPECT_EQ(stats.at("settings").at("volumetrics.technique"), "ray_march");
}

TEST_F(Render, SettingsThatTheTechniqueDoesNotReadAreKeptAndReported) {
  const json stats =
      statsOf(folder_, with(kSmall, {"--set", "volumetrics.basis_count=64", "--set", "volumetrics.columns=128", "--set",
                                     "volumetrics.reuse=false", "--set", "medium.g=0.3", "--set", "view.exposure=2",
                                     "--set", "volumetrics.technique=ray_march"}));
  EXPECT_EQ(stats.at("settings").at("volumetrics.basis_count"), 64);
  const std::vector<std::string> unused = stats.at("unused_settings");
  const auto has = [&](const char* id) { return std::find(unused.begin(), unused.end(), id) != unused.end(); };
  EXPECT_TRUE(has("volumetrics.basis_count"));
  EXPECT_TRUE(has("volumetrics.columns"));
  EXPECT_FALSE(has("medium.g"));
  EXPECT_FALSE(has("view.exposure"));
  EXPECT_FALSE(has("volumetrics.technique"));
}

TEST_F(Render, StatsSettingsAreEveryParameter) {
  const json described = json::parse(tyndall({"describe", "--json"}).out);
  const json stats = statsOf(folder_, kSmall);
  EXPECT_EQ(stats.at("settings").size(), described.at("parameters").size());
  for (const json& parameter : described.at("parameters"))
    EXPECT_EQ(stats.at("settings").at(parameter.at("id").get<std::string>()), parameter.at("default"));
}

TEST_F(Render, OddAndTinySizes) {
  for (const char* size : {"1x1", "1x77", "33x1", "97x53"}) {
    const Outcome outcome = tyndall({"render", "hall", "--size", size, "--scatter", "s.exr"});
    ASSERT_EQ(outcome.status, 0) << size << ": " << outcome.err;
    auto scatter = image::readExr(folder_ / "s.exr");
    ASSERT_TRUE(scatter);
    EXPECT_EQ(std::to_string(scatter->width) + "x" + std::to_string(scatter->height), size);
    for (const float value : scatter->values) ASSERT_TRUE(std::isfinite(value)) << size;
  }
}

// Every view that describe lists is shown with a technique that has it, and no two have one name.
TEST_F(Render, DebugViewsOfEngineAndPlugin) {
  const json described = json::parse(tyndall({"describe", "--json"}).out);
  std::set<std::string> names;
  std::map<std::string, std::string> lastOf;  // technique ("" for the engine): the last of its views
  for (const json& view : described.at("debug_views")) {
    EXPECT_TRUE(names.insert(view.at("name")).second) << view;
    EXPECT_EQ(view.at("techniques").empty(), view.at("owner") == "engine") << view;
    if (view.at("owner") == "engine") lastOf[""] = view.at("name");
    for (const std::string technique : view.at("techniques")) lastOf[technique] = view.at("name");
  }
  EXPECT_EQ(lastOf.size(), 7u);
  for (const auto& [technique, name] : lastOf) {
    std::vector<std::string> call = with(kSmall, {"--debug-view", name, "--out", "v.png"});
    if (!technique.empty()) call.insert(call.end(), {"--set", "volumetrics.technique=" + technique});
    const Outcome outcome = tyndall(call);
    EXPECT_EQ(outcome.status, 0) << name << ": " << outcome.err;
  }
}

TEST_F(Render, TheNumbersOfAViewAreThoseOfItsImage) {
  const Outcome outcome =
      tyndall(with(kSmall, {"--debug-view", "scatter", "--view-exr", "v.exr", "--scatter", "s.exr"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  auto view = image::readExr(folder_ / "v.exr"), scatter = image::readExr(folder_ / "s.exr");
  ASSERT_TRUE(view && scatter);
  EXPECT_EQ(view->values, scatter->values);
  // Two channels: a third of zeros, as an EXR of two has no names for them. Of a map's own size.
  const Outcome map =
      tyndall(with(kSmall, {"--set", "volumetrics.row_order=column", "--set", "volumetrics.columns=64", "--set",
                            "volumetrics.slices=128", "--debug-view", "prefix_min", "--view-exr", "m.exr"}));
  ASSERT_EQ(map.status, 0) << map.err;
  auto bounds = image::readExr(folder_ / "m.exr");
  ASSERT_TRUE(bounds);
  EXPECT_EQ(bounds->width, 128u);
  EXPECT_EQ(bounds->height, 64u);
  EXPECT_EQ(bounds->channels, 3u);
  for (std::uint32_t x = 0; x < bounds->width; ++x)
    for (std::uint32_t y = 1; y < bounds->height; ++y)
      ASSERT_LE(bounds->at(x, y, 0), bounds->at(x, y - 1, 0));  // a prefix minimum falls
}

TEST_F(Render, ALevelWithoutCameraAndLightSaysSo) {
  // One triangle; the buffer is three positions.
  writeText(
      folder_ / "bare.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
      R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const Outcome outcome = tyndall({"render", "bare.gltf", "--size", "64x36", "--out", "a.png"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("camera"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("light"), std::string::npos) << outcome.err;
}

TEST_F(Render, ValidationIsSilent) {
  for (const std::string& technique : techniques()) {
    const Outcome outcome = tyndall(with(kSmall, {"--validate", "--set", "volumetrics.technique=" + technique}));
    EXPECT_EQ(outcome.status, 0) << technique << ": " << outcome.err;
  }
}

TEST_F(Render, ValidationIsSilentWithMomentShadowMaps) {
  for (const char* level : {"hall", "forest"})
    for (const char* precision : {"64", "128"}) {
      const Outcome outcome = tyndall(
          {"render", level, "--size", "64x36", "--validate", "--out", "m.png", "--set", "shadows.resolution=256",
           "--set", "volumetrics.columns=64", "--set", "volumetrics.slices=64", "--set", "shadows.mode=moments",
           "--set", "volumetrics.filtered_resampling=true", "--set", std::string("shadows.precision=") + precision});
      EXPECT_EQ(outcome.status, 0) << level << ' ' << precision << ": " << outcome.err;
    }
}

TEST_F(Render, ThePrecisionOfMomentsIsUnusedUnlessSomethingReadsThem) {
  const auto unused = [&](std::vector<std::string> settings) {
    std::vector<std::string> call = with(kSmall, {"--set", "shadows.precision=128"});
    for (const std::string& setting : settings) call.insert(call.end(), {"--set", setting});
    const json stats = statsOf(folder_, call);
    bool made = false;
    for (const json& pass : stats.at("passes"))
      made = made || pass.at("name").get<std::string>().starts_with("moments ");
    const std::vector<std::string> ids = stats.at("unused_settings");
    const bool listed = std::find(ids.begin(), ids.end(), "shadows.precision") != ids.end();
    EXPECT_NE(made, listed) << "maps are made if and only if something reads them";
    return listed;
  };
  EXPECT_TRUE(unused({}));
  EXPECT_FALSE(unused({"shadows.mode=moments"}));
  EXPECT_FALSE(unused({"volumetrics.technique=moments6", "volumetrics.filtered_resampling=true"}));
  EXPECT_TRUE(unused({"volumetrics.technique=min_max", "volumetrics.filtered_resampling=true"}))
      << "its bounds must not be means";
  EXPECT_TRUE(unused({"volumetrics.technique=ray_march", "volumetrics.filtered_resampling=true"}));
  EXPECT_TRUE(unused({"volumetrics.enabled=false", "volumetrics.filtered_resampling=true"}));
}

}  // namespace
}  // namespace tyndall::cli
