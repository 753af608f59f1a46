// From a sweep to points: techniques come from the registry, and a parameter is tried where it is read.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "bench/points.hpp"

namespace tyndall::bench {
namespace {

struct Points : testing::Test {
  void SetUp() override {
    auto loaded = app::Catalogue::load(std::filesystem::path(TYNDALL_BIN_DIR) / "plugins");
    ASSERT_TRUE(loaded) << loaded.error().message;
    catalogue = loaded.take();
  }
  std::vector<PlannedPoint> plan(const Sweep& sweep) {
    auto points = pointsOf(sweep, *catalogue, "level", 1, 1);
    EXPECT_TRUE(points) << points.error().message;
    return points ? points.take() : std::vector<PlannedPoint>{};
  }
  bool reads(const std::string& technique, const std::string& id) const {
    for (const host::TechniqueInfo& t : catalogue->effectPlugin().techniques())
      if (t.id == technique) return std::find(t.reads.begin(), t.reads.end(), id) != t.reads.end();
    return false;
  }
  std::unique_ptr<app::Catalogue> catalogue;
};

TEST_F(Points, EveryTechniqueOfTheRegistryIsThere) {
  std::set<std::string> techniques;
  for (const PlannedPoint& p : plan({})) techniques.insert(p.figures.technique);
  for (const host::TechniqueInfo& t : catalogue->effectPlugin().techniques())
    EXPECT_TRUE(techniques.contains(t.id)) << t.id;
  EXPECT_EQ(techniques.size(), catalogue->effectPlugin().techniques().size());
}

TEST_F(Points, AKnobIsTriedWhereItIsRead) {
  Sweep sweep;
  sweep.everyTechnique = false;
  sweep.knobs = {{"volumetrics.steps", {"16", "32"}, {}, {{"volumetrics.basis_count", "8"}}, {"knob"}}};
  std::set<std::string> techniques;
  for (const PlannedPoint& p : plan(sweep)) {
    EXPECT_TRUE(reads(p.figures.technique, "volumetrics.steps"));
    techniques.insert(p.figures.technique);
    EXPECT_EQ(p.figures.knob->first, "volumetrics.steps");
    EXPECT_EQ(p.all.at("volumetrics.steps"), p.figures.knob->second);
    EXPECT_FALSE(p.all.contains("volumetrics.basis_count")) << "nobody who marches reads it";
  }
  for (const host::TechniqueInfo& t : catalogue->effectPlugin().techniques())
    EXPECT_EQ(techniques.contains(t.id), reads(t.id, "volumetrics.steps")) << t.id;
  // The engine's parameters bear on all.
  sweep.knobs = {{"shadows.resolution", {"512"}, {}, {}, {"knob"}}};
  EXPECT_EQ(plan(sweep).size(), catalogue->effectPlugin().techniques().size());
}

TEST_F(Points, WhatIsTheSameIsMeasuredOnce) {
  Sweep sweep;
  sweep.knobs = {{"volumetrics.reference_rays", {"3", "4"}, {}, {}, {"knob"}}};  // 3 is the default
  std::set<std::string> measurements, keys;
  std::size_t count = 0;
  for (const PlannedPoint& p : plan(sweep)) {
    if (p.figures.technique != "exact") continue;
    ++count;
    measurements.insert(p.measurement);
    keys.insert(p.figures.key);
  }
  EXPECT_EQ(count, 3u);  // default, 3, 4
  EXPECT_EQ(keys.size(), 3u);
  EXPECT_EQ(measurements.size(), 2u);
  // However a value is written.
  Sweep other;
  other.settings = {{"medium.sigma_t", "0.0300"}};
  Sweep plain;
  EXPECT_EQ(plan(other).front().measurement, plan(plain).front().measurement);
}

TEST_F(Points, OtherReferencesMakeOtherPoints) {
  Sweep sweep, other;
  other.truthSamples = sweep.truthSamples + 1;
  const auto a = plan(sweep), b = plan(other);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NE(a[i].figures.key, b[i].figures.key);
    EXPECT_EQ(a[i].measurement, b[i].measurement);
  }
}

TEST_F(Points, APointThatStandsTwiceSpoilsNoOther) {
  Sweep sweep;
  sweep.everyTechnique = false;
  const Single single{"a",  "b", {{"volumetrics.technique", "exact"}}, {"papers"}, PaperFigure{"P", "T", "R", 1.0, 0.1},
                      false};
  Single again = single;
  again.paper->row = "another";
  sweep.singles = {single, again};
  const auto points = plan(sweep);
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].figures.paper->row, "R");
}

TEST_F(Points, PointsOfMotionMove) {
  Sweep sweep;
  sweep.everyTechnique = false;
  sweep.motion.frames = 3;
  sweep.knobs = {{"volumetrics.jitter", {"none", "white"}, {}, {}, {"motion"}}};
  for (const PlannedPoint& p : plan(sweep)) EXPECT_TRUE(p.motion) << p.figures.key;
}

TEST_F(Points, ParametersThatGoTogetherDo) {
  Sweep sweep;
  sweep.everyTechnique = false;
  sweep.knobs = {{"volumetrics.columns", {"256"}, {"volumetrics.slices"}, {}, {"map"}}};
  const auto points = plan(sweep);
  ASSERT_FALSE(points.empty());
  for (const PlannedPoint& p : points) EXPECT_EQ(p.all.at("volumetrics.slices"), "256");
}

TEST_F(Points, WrongValuesAreNamed) {
  Sweep sweep;
  sweep.name = "mine";
  sweep.settings = {{"volumetrics.colums", "3"}};
  auto points = pointsOf(sweep, *catalogue, "level", 1, 0);
  ASSERT_FALSE(points);
  EXPECT_NE(points.error().message.find("mine"), std::string::npos);
  EXPECT_NE(points.error().message.find("volumetrics.columns"), std::string::npos);
  EXPECT_EQ(points.error().kind, ErrorKind::kBadCall);
  sweep.settings.clear();
  sweep.knobs = {{"volumetrics.step", {"3"}, {}, {}, {"knob"}}};
  EXPECT_FALSE(pointsOf(sweep, *catalogue, "level", 1, 0));
  sweep.knobs = {{"volumetrics.steps", {"-3"}, {}, {}, {"knob"}}};
  EXPECT_FALSE(pointsOf(sweep, *catalogue, "level", 1, 0));
  // The references are made for the medium that all points share.
  sweep.knobs = {{"medium.g", {"0.1"}, {}, {}, {"knob"}}};
  auto medium = pointsOf(sweep, *catalogue, "level", 1, 0);
  ASSERT_FALSE(medium);
  EXPECT_NE(medium.error().message.find("medium.g"), std::string::npos);
}

TEST_F(Points, PaperFiguresKnowTheirBruteForce) {
  Sweep sweep;
  sweep.everyTechnique = false;
  sweep.singles = {
      {"a", "b", {{"volumetrics.technique", "exact"}}, {"papers"}, PaperFigure{"P", "T", "R", 1.0, 0.1}, false},
      {"march", "c", {{"volumetrics.technique", "ray_march"}}, {"papers"}, {}, true}};
  const auto points = plan(sweep);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].figures.baselineKey, points[1].figures.key);
}

}  // namespace
}  // namespace tyndall::bench
