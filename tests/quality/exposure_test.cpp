// Pictures are neither white nor black whatever the light's unit, unless the level or the user says otherwise; and who
// sees nothing for haze is told so.
#include <cmath>

#include <nlohmann/json.hpp>

#include "pictures.hpp"
#include "scene/gltf.hpp"
#include "scene/write_glb.hpp"

namespace tyndall::quality {
namespace {

class Exposure : public QualityTest {
 protected:
  void SetUp() override {
    QualityTest::SetUp();
    level_ = writeLevel("plate", {plate(-30, 30, -40, 20, 0), plate(-4, 4, -12, -2, 5)}, {0.3f, -0.8f, -0.4f});
  }
  /// The level with another sun and hint.
  std::string variant(float lux, std::optional<float> hint) const {
    auto import = scene::loadGltf(folder_ / level_);
    EXPECT_TRUE(import);
    import->scene.lights[0].intensity = lux;
    import->scene.exposure = hint;
    EXPECT_TRUE(scene::writeGlb(import->scene, folder_ / "variant.glb"));
    return "variant.glb";
  }
  struct Shown {
    image::ByteImage picture;
    nlohmann::json exposure, notes;
    std::vector<std::string> passes;
  };
  Shown show(const std::string& level, const Arguments& settings = {}) const {
    Arguments call = {"render", level,     "--size", "160x90", "--out",
                      "p.png",  "--stats", "s.json", "--set",  "volumetrics.technique=ray_march"};
    for (const std::string& setting : settings) call.insert(call.end(), {"--set", setting});
    const cli::Outcome outcome = tyndall(call);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    auto picture = image::readPng(folder_ / "p.png");
    EXPECT_TRUE(picture);
    const auto stats = nlohmann::json::parse(cli::readText(folder_ / "s.json"));
    Shown shown{picture.take(), stats.at("exposure"), stats.at("notes"), {}};
    for (const auto& pass : stats.at("passes")) shown.passes.push_back(pass.at("name"));
    return shown;
  }
  static double mean(const image::ByteImage& picture) {
    double sum = 0;
    for (const std::uint8_t value : picture.values) sum += value;
    return sum / (255.0 * static_cast<double>(picture.values.size()));
  }
  std::string level_;
};

TEST_F(Exposure, IsTheSamePictureInEveryUnit) {
  const Shown base = show(variant(8, {}));
  EXPECT_EQ(base.exposure.at("source"), "automatic");
  EXPECT_GT(mean(base.picture), 0.2);
  EXPECT_LT(mean(base.picture), 0.8);
  for (const float scale : {0.3f, 37.0f, 1e4f, 1e8f}) {
    const Shown other = show(variant(8 * scale, {}));
    // The factor undoes the scale to a tenth of a bin.
    EXPECT_NEAR(std::log2(other.exposure.at("factor").get<double>() * scale / base.exposure.at("factor").get<double>()),
                0, 0.05)
        << scale;
    EXPECT_NEAR(mean(other.picture), mean(base.picture), 0.01) << scale;
  }
  // A factor on top acts as it says.
  EXPECT_NEAR(show(variant(8, {}), {"view.exposure=3"}).exposure.at("factor").get<double>(),
              3 * base.exposure.at("factor").get<double>(), 1e-3 * base.exposure.at("factor").get<double>());
}

TEST_F(Exposure, ALevelsHintStandsUnlessTheUserSaysOtherwise) {
  const Shown hinted = show(variant(8, 0.25f));
  EXPECT_EQ(hinted.exposure, (nlohmann::json{{"source", "level"}, {"factor", 0.25}}));
  for (const std::string& pass : hinted.passes) EXPECT_EQ(pass.find("exposure"), std::string::npos) << pass;
  EXPECT_EQ(show(variant(8, 0.25f), {"view.exposure=2"}).exposure.at("factor"), 0.5);
  EXPECT_EQ(show(variant(8, 0.25f), {"view.auto_exposure=true"}).exposure.at("source"), "automatic");
  EXPECT_EQ(show(variant(8, 0.25f), {"view.auto_exposure=false"}).exposure.at("source"), "level");
  const Shown fixed = show(variant(8, {}), {"view.auto_exposure=false"});
  EXPECT_EQ(fixed.exposure, (nlohmann::json{{"source", "fixed"}, {"factor", 1.0}}));
  // Fixed at what a hint says is the hint's picture.
  EXPECT_EQ(show(variant(8, {}), {"view.auto_exposure=false", "view.exposure=0.25"}).picture.values,
            hinted.picture.values);
}

TEST_F(Exposure, AHintThatIsNoneIsPassedOverInALine) {
  for (const char* bad : {"\"bright\"", "0", "-1", "1e300", "[1]"}) {
    cli::writeText(folder_ / "bad.gltf",
                   std::string(R"({"asset": {"version": "2.0", "extras": {"tyndall": {"exposure": )") + bad +
                       "}}}, \"scene\": 0, \"scenes\": [{}]}");
    const cli::Outcome outcome =
        tyndall({"render", "bad.gltf", "--size", "16x16", "--out", "p.png", "--set", "volumetrics.technique=none"});
    EXPECT_EQ(outcome.status, 0) << bad << outcome.err;
    EXPECT_NE(outcome.err.find("tyndall.exposure"), std::string::npos) << bad << outcome.err;
  }
}

// Nothing is measured of black: no division by no light, no exposure that runs away.
TEST_F(Exposure, OfNothingIsOne) {
  EXPECT_EQ(show(variant(0, {}), {"volumetrics.enabled=false"}).exposure.at("source"), "automatic");
  const Shown dark = show(variant(0, {}), {"volumetrics.enabled=false"});
  EXPECT_TRUE(std::isfinite(dark.exposure.at("factor").get<double>()));
}

TEST_F(Exposure, HazeThatHidesTheLevelIsToldWithTheValueThatShowsIt) {
  const auto told = [](const Shown& shown) {
    for (const std::string note : shown.notes)
      if (note.find("medium.sigma_t=") != std::string::npos) return note;
    return std::string();
  };
  EXPECT_EQ(told(show(level_)), "");
  const std::string line = told(show(level_, {"medium.sigma_t=2"}));
  ASSERT_NE(line, "");
  const std::size_t at = line.find("medium.sigma_t=");
  const std::string value = line.substr(at, line.find(' ', at) - at);
  EXPECT_EQ(told(show(level_, {value})), "") << value;
  // Half of the light of the median surface comes through.
  const cli::Outcome seen =
      tyndall({"render", level_, "--size", "160x90", "--scatter", "s.exr", "--depth", "d.exr", "--set", value});
  ASSERT_EQ(seen.status, 0) << seen.err;
  std::vector<float> through;
  const image::FloatImage scatter = read("s.exr"), depth = read("d.exr");
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 160; ++x)
      if (depth.at(x, y, 0) < 59.9f) through.push_back(scatter.at(x, y, 3));
  std::nth_element(through.begin(), through.begin() + static_cast<std::ptrdiff_t>(through.size() / 2), through.end());
  EXPECT_NEAR(through[through.size() / 2], 0.5, 0.08);
  // Without air nothing is hidden by it.
  EXPECT_EQ(told(show(level_, {"medium.sigma_t=2", "volumetrics.enabled=false"})), "");
}

}  // namespace
}  // namespace tyndall::quality
