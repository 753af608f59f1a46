// The tuner: what it picks, what it ignores, what it remembers.
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "temporary_folder.hpp"
#include "tuner.hpp"

namespace tyndall::host {
namespace {

const std::vector<double> kVariants = {10, 20, 30};

/// Runs frames until the choice settles; the time of a frame is a function of variant and frame.
template <class Time>
int settle(Tuner& tuner, const std::string& key, Time time) {
  for (int frame = 0; frame < 100; ++frame) {
    const auto choice = tuner.current(key, kVariants);
    if (choice.settled) return frame;
    tuner.add(key, choice.variant, time(choice.variant, frame % 4));
  }
  return -1;
}

TEST(Tuner, picksTheSmallestMedianAndIgnoresTheWarmUp) {
  Tuner tuner{TunerStore({})};
  // Variant 1 is fastest by median, though it compiles long, and stutters once.
  const double times[3][4] = {{5, 5, 5, 5}, {900, 80, 2, 2}, {1, 3, 3, 3}};
  EXPECT_EQ(settle(tuner, "k", [&](std::size_t v, int f) { return times[v][f]; }), 12);
  EXPECT_EQ(tuner.current("k", kVariants).variant, 1u);
  tuner.add("k", 1, 1e9);  // later times change nothing
  EXPECT_EQ(tuner.current("k", kVariants).variant, 1u);
}

TEST(Tuner, doesNotDwellOnWhatIsClearlySlower) {
  Tuner tuner{TunerStore({})};
  const double times[3][4] = {{5, 5, 5, 5}, {900, 9, 9, 0}, {1, 7, 7, 4}};
  EXPECT_EQ(settle(tuner, "k", [&](std::size_t v, int f) { return times[v][f]; }), 4 + 3 + 4);
  EXPECT_EQ(tuner.current("k", kVariants).variant, 0u);
}

TEST(Tuner, timesOfAnotherVariantAreIgnored) {
  Tuner tuner{TunerStore({})};
  tuner.current("k", kVariants);
  for (int i = 0; i < 50; ++i) tuner.add("k", 2, 0.001), tuner.add("unknown", 0, 1);
  EXPECT_EQ(tuner.current("k", kVariants).variant, 0u);
  EXPECT_FALSE(tuner.current("k", kVariants).settled);
}

// Lights that come into view while variants are timed would make the later ones look slow.
TEST(Tuner, variantsAreComparedOnTheSameLights) {
  Tuner tuner{TunerStore({})};
  int frame = 0;
  while (!tuner.current("k", kVariants).settled && frame < 100) {
    const std::size_t variant = tuner.current("k", kVariants).variant;
    const bool second = frame >= 6;                          // variant 1 is being timed
    const double once = 3.0 - static_cast<double>(variant);  // the last is the fastest
    tuner.add("k", variant, second ? 10 * once : once,
              second ? std::set<std::uint32_t>{0, 1} : std::set<std::uint32_t>{0});
    ++frame;
  }
  EXPECT_EQ(frame, 7 + 12);
  EXPECT_EQ(tuner.current("k", kVariants).variant, 2u);
}

TEST(Tuner, withoutTimesStaysAtTheFirst) {
  Tuner tuner{TunerStore({})};
  for (int i = 0; i < 50; ++i) EXPECT_EQ(tuner.current("k", kVariants).variant, 0u);
}

TEST(Tuner, remembersBetweenRuns) {
  test::TemporaryFolder folder;
  const auto file = folder.path() / "tunables.json";
  {
    Tuner tuner{TunerStore(file)};
    settle(tuner, "k", [](std::size_t v, int) { return 10.0 - static_cast<double>(v); });
    settle(tuner, "other", [](std::size_t v, int) { return static_cast<double>(v); });
  }
  Tuner tuner{TunerStore(file)};
  EXPECT_TRUE(tuner.current("k", kVariants).settled);
  EXPECT_EQ(tuner.current("k", kVariants).variant, 2u);
  EXPECT_EQ(tuner.current("other", kVariants).variant, 0u);
  EXPECT_FALSE(tuner.current("k", {10, 20}).settled) << "30 is no variant any more: timed anew";
}

TEST(Tuner, aDamagedFileIsAnEmptyOne) {
  test::TemporaryFolder folder;
  const auto file = folder.path() / "tunables.json";
  for (const std::string& text : {std::string(""), std::string("["), std::string("[1]"), std::string(R"({"k": "20"})"),
                                  std::string(R"({"k": 17})"), std::string(100000, '[')}) {
    ASSERT_TRUE(writeTextAtomically(file, text));
    Tuner tuner{TunerStore(file)};
    EXPECT_FALSE(tuner.current("k", kVariants).settled) << text.substr(0, 20);
  }
  Tuner tuner{TunerStore(file)};
  settle(tuner, "k", [](std::size_t v, int) { return static_cast<double>(v); });
  EXPECT_TRUE(Tuner{TunerStore(file)}.current("k", kVariants).settled);
}

TEST(Tuner, keyNamesWhatAChoiceHoldsFor) {
  Layout layout;
  LayoutPass pass;
  pass.name = "sum";
  pass.d.groups[0] = pass.d.groups[1] = pass.d.groups[2] = 100;
  layout.passes.push_back(pass);
  const LayoutTunable tunable{0, 0, {1, 2}, {"sum"}};
  const std::string key = tunableKey("p 1.0", "gpu|driver", "fog.scheme", tunable, layout);
  EXPECT_NE(key, tunableKey("p 1.1", "gpu|driver", "fog.scheme", tunable, layout));
  EXPECT_NE(key, tunableKey("p 1.0", "other|driver", "fog.scheme", tunable, layout));
  EXPECT_NE(key, tunableKey("p 1.0", "gpu|driver", "fog.other", tunable, layout));
  layout.passes[0].shader = "other.comp";
  EXPECT_NE(key, tunableKey("p 1.0", "gpu|driver", "fog.scheme", tunable, layout)) << "another kernel";
  layout.passes[0].shader.clear();
  layout.passes[0].d.groups[0] = 101;
  EXPECT_EQ(key, tunableKey("p 1.0", "gpu|driver", "fog.scheme", tunable, layout)) << "nearly the same size";
  layout.passes[0].d.groups[0] = 300;
  EXPECT_NE(key, tunableKey("p 1.0", "gpu|driver", "fog.scheme", tunable, layout));
}

}  // namespace
}  // namespace tyndall::host
