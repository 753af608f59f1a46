// The call itself: refusals, progress, cancelling, threads.
#include <algorithm>
#include <limits>
#include <thread>

#include "level.hpp"

using namespace truth_test;

namespace {

/// Boards that make a picture with light and shade everywhere.
scene::Scene boards() {
  scene::Scene level;
  for (int i = 0; i < 20; ++i) addQuad(level, {static_cast<float>(i) - 10, 4, -50}, {0.5f, 0, 0}, {0, 0, 100});
  addQuad(level, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
  return level;
}

truth::Settings small() {
  truth::Settings settings;
  settings.width = 64, settings.height = 36;
  settings.samples = 64;
  return settings;
}

const scene::CameraView kCamera = cameraAt({-8, 1.5f, 0.3f}, {1, 0.05f, -0.1f});
const std::vector<scene::LightView> kLights{sunAlong({0.2f, -1, 0.1f}), pointAt({0, 6, -2})};

}  // namespace

TEST(TruthRender, isTheSameWithAnyNumberOfThreads) {
  auto settings = small();
  settings.threads = 1;
  const auto one = rendered(boards(), kCamera, kLights, settings);
  settings.threads = 5;
  const auto five = rendered(boards(), kCamera, kLights, settings);
  EXPECT_EQ(one.distance, five.distance);
  EXPECT_EQ(one.scatter, five.scatter);
}

TEST(TruthRender, moreSamplesComeNearer) {
  auto settings = small();
  settings.samples = 8192;
  const auto fine = rendered(boards(), kCamera, kLights, settings);
  const auto error = [&](std::uint32_t samples) {
    settings.samples = samples;
    const auto picture = rendered(boards(), kCamera, kLights, settings);
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < fine.scatter.size(); ++i) {
      squares += std::pow(double{picture.scatter[i].r} - fine.scatter[i].r, 2);
      sum += fine.scatter[i].r;
    }
    const double count = static_cast<double>(fine.scatter.size());
    return std::sqrt(squares / count) / (sum / count);
  };
  const double coarse = error(16), middle = error(128), good = error(1024);
  EXPECT_LT(middle, coarse / 3);
  EXPECT_LT(good, middle / 3);
  EXPECT_LT(good, 2e-3);
}

TEST(TruthRender, progressRisesToOneInTheCallingThread) {
  auto settings = small();
  std::vector<double> shares;
  const auto caller = std::this_thread::get_id();
  settings.progress = [&](double share) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    shares.push_back(share);
    return true;
  };
  rendered(boards(), kCamera, kLights, settings);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1);
}

TEST(TruthRender, canBeCancelled) {
  auto settings = small();
  settings.width = 4096, settings.height = 4096;  // minutes
  settings.progress = [](double share) { return share < 1e-3; };
  const auto picture = truth::render(boards(), kCamera, kLights, settings);
  ASSERT_FALSE(picture);
  EXPECT_NE(picture.error().message.find("cancelled"), std::string::npos);
}

TEST(TruthRender, refusesValuesOutOfRange) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const std::function<void(truth::Settings&)>& change, const char* name) {
    truth::Settings settings = small();
    change(settings);
    const auto picture = truth::render({}, kCamera, kLights, settings);
    ASSERT_FALSE(picture) << name;
    EXPECT_EQ(picture.error().kind, tyndall::ErrorKind::kBadCall);
    EXPECT_NE(picture.error().message.find(name), std::string::npos) << picture.error().message;
  };
  refused([](auto& s) { s.width = 0; }, "size");
  refused([](auto& s) { s.height = 100000; }, "size");
  refused([](auto& s) { s.samples = 0; }, "samples");
  refused([](auto& s) { s.medium.sigma_t = -0.1; }, "medium.sigma_t");
  refused([](auto& s) { s.medium.sigma_t = kNan; }, "medium.sigma_t");
  refused([](auto& s) { s.medium.albedo = 1.1; }, "medium.albedo");
  refused([](auto& s) { s.medium.g = 1; }, "medium.g");
  refused([](auto& s) { s.medium.g = kNan; }, "medium.g");
  refused([](auto& s) { s.seconds = kNan; }, "seconds");
  auto camera = kCamera;
  camera.camera.zfar = camera.camera.znear;
  EXPECT_FALSE(truth::render({}, camera, kLights, small()));
}

TEST(TruthRender, withoutLightOrMediumIsBlackAndClear) {
  const auto dark = rendered(boards(), kCamera, {}, small());
  for (const glm::vec4& pixel : dark.scatter) EXPECT_EQ(glm::vec3(pixel), glm::vec3(0));
  auto settings = small();
  settings.medium.sigma_t = 0;
  const auto clear = rendered(boards(), kCamera, kLights, settings);
  for (const glm::vec4& pixel : clear.scatter) EXPECT_EQ(pixel, glm::vec4(0, 0, 0, 1));
}
