// Input that is wrong: the error names the path of the first wrong field; nothing throws, nothing is made up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/report.hpp"
#include "synthetic.hpp"

namespace tyndall::bench {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

std::string errorOf(const std::string& text) {
  const auto html = reportHtml(text);
  EXPECT_FALSE(html) << text.substr(0, 200);
  return html ? "" : html.error().message;
}

std::string errorWith(const std::string& pointer, const json& value) {
  json r = test::results();
  r[json::json_pointer(pointer)] = value;
  return errorOf(r.dump());
}

TEST(Malformed, WhatIsNoResultFile) {
  EXPECT_THAT(errorOf(""), HasSubstr("not valid JSON, line 1"));
  EXPECT_THAT(errorOf("{\n\"format\": \"tyndall-bench\",\n oops"), HasSubstr("line 3"));
  EXPECT_THAT(errorOf("[]"), AllOf(HasSubstr("the file is a list"), HasSubstr("an object would be right")));
  EXPECT_THAT(errorOf("null"), HasSubstr("the file is null"));
  EXPECT_THAT(errorOf("{}"), HasSubstr("format is nothing; \"tyndall-bench\" would be right"));
  EXPECT_THAT(errorOf("{\"format\": \"tyndall-bench\", \"version\": 1}"), HasSubstr("points is nothing; a list"));
  EXPECT_THAT(errorOf(std::string(100000, '[')), HasSubstr("nests deeper than"));
  EXPECT_THAT(errorOf("{\"format\": \"tyndall-bench\", \"version\": 1e999, \"points\": []}"), HasSubstr("too large"));
  EXPECT_THAT(errorOf("{\"format\": \"\xff\xfe\"}"), HasSubstr("not valid JSON"));
}

TEST(Malformed, TheFieldIsNamedByItsPath) {
  EXPECT_THAT(errorWith("/format", "other"), HasSubstr("format is \"other\""));
  EXPECT_THAT(errorWith("/version", 2), HasSubstr("version is 2; 1 would be right"));
  EXPECT_THAT(errorWith("/copy_gb_s", "fast"), HasSubstr("copy_gb_s is \"fast\"; a number"));
  EXPECT_THAT(errorWith("/levels", 3), HasSubstr("levels is 3; a list"));
  EXPECT_THAT(errorWith("/levels/1/truth_self_nrmse", -0.1),
              HasSubstr("levels[1].truth_self_nrmse is -0.1; 0 or more"));
  EXPECT_THAT(errorWith("/levels/0/light_in_view", "yes"), HasSubstr("levels[0].light_in_view"));
  EXPECT_THAT(errorWith("/points/3/volumetrics_ms/median", "12"),
              HasSubstr("points[3].volumetrics_ms.median is \"12\"; a number would be right"));
  EXPECT_THAT(errorWith("/points/3/volumetrics_ms/low", 1e9),
              HasSubstr("points[3].volumetrics_ms.low is 1000000000.0; at most the median"));
  EXPECT_THAT(errorWith("/points/3/gpu_ms/high", 0), HasSubstr("points[3].gpu_ms.high is 0; at least the median"));
  EXPECT_THAT(errorWith("/points/0/size", {640}), HasSubstr("points[0].size is a list; [width, height]"));
  EXPECT_THAT(errorWith("/points/0/size/1", 0.5), HasSubstr("points[0].size[1] is 0.5; a whole number"));
  EXPECT_THAT(errorWith("/points/0/camera", -1), HasSubstr("points[0].camera"));
  EXPECT_THAT(errorWith("/points/0/plot", "knob"), HasSubstr("points[0].plot is \"knob\"; a list"));
  EXPECT_THAT(errorWith("/points/2/plot/0", 7), HasSubstr("points[2].plot[0] is 7; text"));
  EXPECT_THAT(errorWith("/points/1/passes/1/ms", true), HasSubstr("points[1].passes[1].ms is true; a number"));
  EXPECT_THAT(errorWith("/points/1/error/truth/silhouettes/nrmse", json::array()),
              HasSubstr("points[1].error.truth.silhouettes.nrmse is a list; a number"));
  EXPECT_THAT(errorWith("/points/1/error", "none"), HasSubstr("points[1].error is \"none\"; an object"));
  EXPECT_THAT(errorWith("/points/1/failed", false), HasSubstr("points[1].failed is false; text"));
  EXPECT_THAT(errorWith("/points/1", 5), HasSubstr("points[1] is 5; an object"));
  EXPECT_THAT(errorWith("/points/1", nullptr), HasSubstr("points[1] is null; an object"));
}

TEST(Malformed, AnyWrongTypeAnywhereIsAnErrorOrHarmless) {
  // A scalar of each kind in turn becomes a list: an error that names it, or, where any value is right (settings), a
  // page.
  const json flat = test::results().flatten();
  std::set<std::string> tried;
  int errors = 0;
  for (const auto& item : flat.items()) {
    std::string kind;
    for (const char c : item.key())
      if (!std::isdigit(static_cast<unsigned char>(c))) kind += c;
    if (!tried.insert(kind).second) continue;
    json r = test::results();
    r[json::json_pointer(item.key())] = json::array({7});
    const auto html = reportHtml(r.dump());
    const bool anyValue = item.key().find("/settings/") != std::string::npos || item.key().ends_with("/knob/value");
    EXPECT_EQ(html.ok(), anyValue) << item.key();
    if (html) continue;
    ++errors;
    // "/points/3/size/0" is points[3].size[0].
    std::string path;
    for (std::size_t at = 1; at < item.key().size();) {
      const std::size_t end = std::min(item.key().find('/', at), item.key().size());
      const std::string part = item.key().substr(at, end - at);
      if (std::isdigit(static_cast<unsigned char>(part[0])))
        path += "[" + part + "]";
      else
        path += (path.empty() ? "" : ".") + part;
      at = end + 1;
    }
    EXPECT_THAT(html.error().message, HasSubstr("benchmark results: " + path));
  }
  EXPECT_GT(errors, 60);
}

}  // namespace
}  // namespace tyndall::bench
