// What a user gets who sets nothing: no other technique, at its defaults, is both nearer to the truth and faster.
#include <cstdio>

#include <nlohmann/json.hpp>

#include "pictures.hpp"

namespace tyndall::quality {
namespace {

using DefaultTechnique = QualityTest;

TEST_F(DefaultTechnique, IsBeatenByNoneInErrorAndTime) {
  const image::FloatImage reference = truth("hall", 1024);
  const auto error = [&](const Arguments& settings) { return nRmse(scatter("hall", settings), reference); };
  // Times are those of the default size of a picture, at which maps and pixels cost what they do for users.
  const auto stats = [&](const Arguments& settings) {
    Arguments call = {"render", "hall", "--frames", "3", "--stats", "s.json"};
    for (const std::string& setting : settings) call.insert(call.end(), {"--set", setting});
    const cli::Outcome outcome = tyndall(call);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return nlohmann::json::parse(cli::readText(folder_ / "s.json")).at("volumetrics");
  };
  const auto standard = stats({});
  const std::string name = standard.at("technique");
  const double standardMs = standard.at("gpu_ms"), standardError = error({});
  std::printf("default %s: nRMSE %.4f, %.1f ms\n", name.c_str(), standardError, standardMs);
  EXPECT_LT(standardError, 0.05);
  for (const std::string& id : techniques()) {
    if (id == name) continue;
    const Arguments chosen = {"volumetrics.technique=" + id};
    const double otherError = error(chosen);
    std::printf("%s: nRMSE %.4f\n", id.c_str(), otherError);
    if (otherError > 0.9 * standardError) continue;
    const double otherMs = stats(chosen).at("gpu_ms");
    std::printf("%s: %.1f ms\n", id.c_str(), otherMs);
    EXPECT_GT(otherMs, 0.8 * standardMs) << id;
  }
}

}  // namespace
}  // namespace tyndall::quality
