// truth: needs no device and agrees with the renderer about what is where.
#include <cmath>

#include "image/image_io.hpp"
#include "process.hpp"

namespace tyndall::cli {
namespace {

using Truth = CliTest;

TEST_F(Truth, WritesPicturesWithoutADevice) {
  const Outcome outcome =
      tyndall({"truth", "hall", "--size", "32x18", "--samples", "8", "--out", "t.exr", "--depth", "d.exr", "--set",
               "medium.sigma_t=0.1"},
              {{"VK_ICD_FILENAMES", "/nonexistent.json"}, {"VK_DRIVER_FILES", "/nonexistent.json"}});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  auto scatter = image::readExr(folder_ / "t.exr");
  auto depth = image::readExr(folder_ / "d.exr");
  ASSERT_TRUE(scatter && depth);
  ASSERT_EQ(scatter->values.size(), 32u * 18 * 4);
  for (std::size_t i = 0; i < depth->values.size(); ++i)
    EXPECT_NEAR(scatter->values[4 * i + 3], std::exp(-0.1 * depth->values[i]), 1e-4) << i;
}

TEST_F(Truth, SeesTheSameDistancesAsTheRenderer) {
  const std::string pose = "-2.5,1.7,6.25,31.5,-7";  // a value that starts with a minus is a value
  ASSERT_EQ(tyndall({"truth", "hall", "--pose", pose, "--size", "64x36", "--samples", "1", "--out", "t.exr", "--depth",
                     "t-depth.exr"})
                .status,
            0);
  ASSERT_EQ(tyndall({"render", "hall", "--pose", pose, "--size", "64x36", "--depth", "r-depth.exr"}).status, 0);
  auto truth = image::readExr(folder_ / "t-depth.exr");
  auto render = image::readExr(folder_ / "r-depth.exr");
  ASSERT_TRUE(truth && render);
  // Pixels at the edges of surfaces may fall to either side.
  std::size_t apart = 0;
  for (std::size_t i = 0; i < truth->values.size(); ++i)
    apart += std::abs(truth->values[i] - render->values[i]) > 0.01f * truth->values[i];
  EXPECT_LT(apart, truth->values.size() / 50);
}

}  // namespace
}  // namespace tyndall::cli
