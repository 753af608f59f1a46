// results.json there and back, the CSV, the comparison of two.
#include <gtest/gtest.h>

#include "bench/report.hpp"
#include "bench/results.hpp"
#include "bench/sweep.hpp"

namespace tyndall::bench {
namespace {

PointFigures point(const std::string& key, double ms, double error) {
  PointFigures p;
  p.key = key, p.level = "hall", p.size = {64, 36}, p.series = "exact", p.technique = "exact",
  p.label = "K = \"3\", all", p.plots = {"error_time", "knob"};
  p.knob = {{"volumetrics.reference_rays", "3"}};
  p.settings = {{"volumetrics.reference_rays", "3"}, {"volumetrics.technique", "exact"}};
  p.gpu = {ms + 1, ms + 0.5, ms + 2, 3};
  p.volumetrics = {ms, ms * 0.9, ms * 1.1, 3};
  p.shadows = {0.25, 0.25, 0.25, 3};
  p.passes = {{"shadow 0", "engine", 0.25}, {"build [light 0]", "volumetrics", ms}};
  p.memoryBytes = 123456789012;
  p.truth = SplitErrors{Errors{error, 2 * error, 3 * error, -error, 100},
                        {},
                        Errors{error, 0.1, 0.2, 0.3, 60},
                        Errors{0.5, 0.6, 0.7, 0.8, 40}};
  p.motionError = 0.125, p.flicker = 0.0625;
  return p;
}

Results sample() {
  Results r;
  r.device = "a device", r.driver = "1.0", r.sweep = "quick", r.started = "2026-01-01T00:00:00Z",
  r.command = "tyndall bench --sweep quick";
  r.copyGigabytes = 12.5, r.repetitions = 3;
  r.settings = {{"shadows.resolution", "4096"}};
  r.levels = {{"hall", 0, 1000, 2, true, 512, 0.003}};
  r.points = {point("one", 4, 0.02), point("two", 8, 0.01)};
  PointFigures failed;
  failed.key = "three", failed.level = "hall", failed.size = {64, 36}, failed.series = "fourier",
  failed.technique = "fourier", failed.label = "x", failed.plots = {"error_time"}, failed.failure = "out of memory";
  r.points.push_back(failed);
  r.points[1].paper = PaperFigure{"Klehm 2014", "Table 1", "row", 1.5, {}};
  r.points[1].baselineKey = "one";
  r.points[1].movedBytes = 987654321012u;
  return r;
}

TEST(Results, JsonThatNestsDeepIsRefusedInALine) {
  const std::string deep(100000, '[');
  const auto results = readResults(deep, "r.json");
  ASSERT_FALSE(results);
  EXPECT_NE(results.error().message.find("r.json: its JSON nests deeper than"), std::string::npos);
  const auto sweep = readSweep("{\"name\": " + deep + "}", "s.json");
  ASSERT_FALSE(sweep);
  EXPECT_NE(sweep.error().message.find("s.json: its JSON nests deeper than"), std::string::npos);
}

TEST(Results, GoThereAndBack) {
  const std::string json = resultsJson(sample());
  auto read = readResults(json, "r.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(resultsJson(*read), json);
  ASSERT_EQ(read->points.size(), 3u);
  EXPECT_EQ(read->find("two")->paper->milliseconds, 1.5);
  EXPECT_FALSE(read->find("two")->paper->ratio);
  EXPECT_EQ(read->find("two")->baselineKey, "one");
  EXPECT_EQ(read->find("one")->memoryBytes, 123456789012u);
  EXPECT_FALSE(read->find("one")->movedBytes);
  EXPECT_EQ(read->find("two")->movedBytes, 987654321012u);
  EXPECT_EQ(read->repetitions, 3u);
  EXPECT_FALSE(read->find("one")->truth->silhouettes);
  EXPECT_EQ(read->find("three")->failure, "out of memory");
  EXPECT_EQ(read->find("four"), nullptr);
}

TEST(Results, TheReportTakesThem) {
  auto html = reportHtml(resultsJson(sample()));
  ASSERT_TRUE(html) << html.error().message;
  EXPECT_NE(html->find("out of memory"), std::string::npos);
  EXPECT_NE(html->find("a device"), std::string::npos);
}

TEST(Results, DamageIsNamed) {
  EXPECT_NE(readResults("{", "r.json").error().message.find("r.json"), std::string::npos);
  EXPECT_NE(readResults("{}", "r.json").error().message.find("no result"), std::string::npos);
  std::string json = resultsJson(sample());
  json.replace(json.find("\"version\": 1"), 12, "\"version\": 9");
  EXPECT_NE(readResults(json, "r.json").error().message.find("version 9"), std::string::npos);
  json = resultsJson(sample());
  json.replace(json.find("\"driver\""), 8, "\"river\"");
  EXPECT_NE(readResults(json, "r.json").error().message.find("driver"), std::string::npos);
}

TEST(Results, TheCsvHasALineAPointAndQuotesTexts) {
  const std::string csv = resultsCsv(sample());
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < csv.size();) {
    const std::size_t end = csv.find('\n', at);
    lines.push_back(csv.substr(at, end - at));
    at = end + 1;
  }
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_NE(lines[1].find("\"K = \"\"3\"\", all\""), std::string::npos);
  const auto fields = [](const std::string& line) {
    int count = 1;
    bool inside = false;
    for (const char c : line) {
      if (c == '"') inside = !inside;
      if (c == ',' && !inside) ++count;
    }
    return count;
  };
  for (const std::string& line : lines) EXPECT_EQ(fields(line), fields(lines[0])) << line;
}

TEST(Results, ComparisonGivesRatios) {
  Results a = sample(), b = sample();
  b.points[0] = point("one", 2, 0.04);  // half the time, twice the error
  b.points[1] = point("two", 4, 0.02);
  b.points.push_back(point("five", 1, 1));
  const std::string text = compareResults(a, b);
  EXPECT_NE(text.find("time 0.500, error 2.000"), std::string::npos) << text;
  EXPECT_NE(text.find("median of 2 points"), std::string::npos) << text;
  EXPECT_NE(text.find("2 points stand in one"), std::string::npos) << text;  // "three" failed, "five" is b's alone
}

}  // namespace
}  // namespace tyndall::bench
