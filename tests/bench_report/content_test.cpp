// What the page says, against what follows from the synthetic results' own laws (synthetic.cpp).
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/report.hpp"
#include "document.hpp"
#include "synthetic.hpp"

namespace tyndall::bench {
namespace {

using nlohmann::json;
using test::Element;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::unique_ptr<Element> pageOf(const json& results) {
  const auto html = reportHtml(results.dump());
  EXPECT_TRUE(html) << html.error().message;
  return test::page(html ? *html : "<html/>");
}

json resultsWith(std::vector<json> points) {
  return {{"format", "tyndall-bench"}, {"version", 1}, {"sweep", "s"}, {"points", std::move(points)}};
}

const Element* tableWith(const Element& page, const std::string& caption) {
  for (const Element* t : page.all("table"))
    for (const Element* c : t->all("caption"))
      if (c->text == caption) return t;
  return nullptr;
}

/// The text in a table at a row's and a column's head; "" when either is not there.
std::string cellAt(const Element& table, const std::string& row, const std::string& column) {
  const auto heads = table.all("thead")[0]->all("th");
  for (std::size_t i = 0; i < heads.size(); ++i) {
    if (heads[i]->text != column) continue;
    for (const Element* tr : table.all("tbody")[0]->all("tr"))
      if (tr->children[0]->text == row) return tr->children[i]->text;
  }
  return "";
}

std::string findings(const Element& page) {
  std::string text;
  for (const Element* ul : page.all("ul", "findings")) text += ul->text + "\n";
  return text;
}

TEST(Content, TablesAtEqualErrorFollowThePowerLaws) {
  // March: error = 10/ms. Exact: error = 1/ms, so ten times as fast at any error that both have. Rival: too coarse.
  json results =
      resultsWith({test::point("march", "ray_march", "a", 20, 0.5), test::point("march", "ray_march", "b", 2000, 0.005),
                   test::point("exact", "exact", "a", 5, 0.2), test::point("exact", "exact", "b", 100, 0.01),
                   test::point("rough", "fourier", "a", 1, 0.9), test::point("rough", "fourier", "b", 2, 0.45)});
  const auto page = pageOf(results);
  const Element* table = tableWith(*page, "Time at equal error");
  ASSERT_TRUE(table);
  EXPECT_EQ(cellAt(*table, "march", "nRMSE 0.10"), "100 ms 1.00×");
  EXPECT_EQ(cellAt(*table, "exact", "nRMSE 0.10"), "10.0 ms 0.100×");
  EXPECT_EQ(cellAt(*table, "exact", "nRMSE 0.020"), "50.0 ms 0.100×");
  EXPECT_EQ(cellAt(*table, "rough", "nRMSE 0.10"), "not reached");
  EXPECT_EQ(cellAt(*table, "exact", "nRMSE 0.50"), "≤ 5.00 ms †");
  EXPECT_EQ(cellAt(*table, "exact", "nRMSE 0.0050"), "not reached");
  EXPECT_EQ(cellAt(*table, "march", "nRMSE 0.0050"), "2,000 ms 1.00×");
  const Element* times = tableWith(*page, "nRMSE at equal time");
  ASSERT_TRUE(times);
  EXPECT_EQ(cellAt(*times, "march", "50 ms"), "0.200 1.00×");
  EXPECT_EQ(cellAt(*times, "exact", "50 ms"), "0.0200 0.100×");
  EXPECT_EQ(cellAt(*times, "march", "5.0 ms"), "not reached");
  EXPECT_EQ(cellAt(*times, "exact", "200 ms"), "≤ 0.0100 †");
}

TEST(Content, SentencesSayWhoIsCheaperWhere) {
  // March: ms = 1/error; exact: ms = 0.02/error², dearer than the march at errors below 0.02.
  const auto exact = [](double e) { return test::point("exact", "exact", "e", 0.02 / (e * e), e); };
  const auto march = [](double e) { return test::point("march", "ray_march", "m", 1 / e, e); };
  json results = resultsWith({march(0.5), march(0.004), exact(0.4), exact(0.005)});
  for (json& p : results["points"]) p["volumetrics_ms"].erase("low"), p["volumetrics_ms"].erase("high");
  const std::string text = findings(*pageOf(results));
  EXPECT_THAT(text, HasSubstr("from nRMSE 0.00500 to 0.0200 the plain march is 1.00 to 4.00 times as fast"));
  EXPECT_THAT(text, HasSubstr("from nRMSE 0.0200 to 0.400 exact is 1.00 to 20.0 times as fast"));
  EXPECT_THAT(
      text,
      HasSubstr("exact does not reach less than nRMSE 0.00500; the plain march goes down to 0.00400, at 250 ms."));
  EXPECT_THAT(text, Not(HasSubstr("With more error than any point of exact")));
}

TEST(Content, SentencesNameTheFrontInOrder) {
  json results =
      resultsWith({test::point("march", "ray_march", "m1", 10, 0.5), test::point("exact", "exact", "K = 1", 20, 0.2),
                   test::point("exact", "exact", "K = 2", 30, 0.1), test::point("march", "ray_march", "m2", 25, 0.3),
                   test::point("fourier", "fourier", "f", 90, 0.05)});
  const std::string text = findings(*pageOf(results));
  EXPECT_THAT(
      text,
      HasSubstr(
          "Pareto front: From the least error to the least time: fourier at nRMSE 0.0500, 90.0 ms (f); exact at nRMSE "
          "0.100 to 0.200, 30.0 to 20.0 ms (K = 2 and K = 1); march at nRMSE 0.500, 10.0 ms (m1)."));
  EXPECT_THAT(
      text,
      HasSubstr(
          "exact against fourier at equal error: not reached, their errors do not overlap: every point of fourier has "
          "less error, and its cheapest (90.0 ms) takes less time than 0 of the 2 on the front of exact."));
  EXPECT_THAT(
      text,
      HasSubstr("With more error than any point of exact (over 0.200), the plain march takes as little as 10.0 ms."));
}

TEST(Content, DifferencesWithinTheQuartilesAreNoDifference) {
  json results =
      resultsWith({test::point("march", "ray_march", "a", 100, 0.1), test::point("march", "ray_march", "b", 1000, 0.01),
                   test::point("exact", "exact", "a", 102, 0.1), test::point("exact", "exact", "b", 1020, 0.01)});
  EXPECT_THAT(findings(*pageOf(results)),
              HasSubstr("from nRMSE 0.0100 to 0.100 they differ by no more than the quartiles, 3.00 %"));
}

TEST(Content, TheTruthsOwnErrorIsSaidAndDrawn) {
  const auto page = pageOf(test::results());
  EXPECT_THAT(findings(*page), HasSubstr("The truth differs from itself with half the samples by nRMSE 0.00400"));
  EXPECT_EQ(page->all("line", "rule").size(), 2u)
      << "hall's truth, and the papers' ratio of 1; vault's was not measured";
}

TEST(Content, ShareOfTheBandwidthFloor) {
  // 0.2 · time · 10 GB/s bytes, copied at 10 GB/s: a fifth everywhere.
  const auto page = pageOf(test::results());
  int rows = 0;
  for (const Element* svg : page->all("svg", "plot")) {
    if (svg->attribute("aria-label") != "Share of the bandwidth floor") continue;
    for (const Element* note : svg->all("text", "note")) {
      EXPECT_THAT(note->text, HasSubstr("20.0 % ("));
      ++rows;
    }
  }
  EXPECT_EQ(rows, 6);  // three series in two levels
}

TEST(Content, SharesOfTheSquaredError) {
  // silhouettes: (3e)² · 0.05 = 0.45 e²; interior: (0.7e)² · 0.95 = 0.4655 e².
  const auto page = pageOf(test::results());
  const Element* table = tableWith(*page, "Share of the squared error, and of the pixels");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->all("tbody")[0]->all("tr")[0]->children[1]->text, "49.2 % of 5.00 %");
  EXPECT_EQ(table->all("tbody")[0]->all("tr")[0]->children[3]->text, "–");
}

TEST(Content, ThePapersTableHoldsRatiosAgainstEachOther) {
  const auto page = pageOf(test::results());
  for (const Element* t : page->all("table")) {
    if (t->all("thead")[0]->text.find("paper / brute force") == std::string::npos) continue;
    // Ours: 96 ms over the march's 3 · 64 ms.
    EXPECT_EQ(cellAt(*t, "Sponza", "paper, ms"), "2.10");
    EXPECT_EQ(cellAt(*t, "Sponza", "here, ms"), "96.0");
    EXPECT_EQ(cellAt(*t, "Sponza", "paper / brute force"), "0.250");
    EXPECT_EQ(cellAt(*t, "Sponza", "here / brute force"), "0.500");
    EXPECT_EQ(cellAt(*t, "Sponza", "ratio here / in the paper"), "2.00");
    return;
  }
  FAIL() << "no papers' table";
}

TEST(Content, EveryPlotFamilyHasItsPlots) {
  const auto page = pageOf(test::results());
  std::map<std::string, int> titles;
  for (const Element* svg : page->all("svg", "plot")) ++titles[svg->attribute("aria-label")];
  EXPECT_EQ(titles["Run time against error, hall camera 0, 1280×720"], 1);
  EXPECT_EQ(titles["Run time against error, vault camera 0, 1280×720"], 1);
  EXPECT_EQ(titles["Run time against error, hall camera 0, 1280×720, against the converged march"], 1);
  EXPECT_EQ(titles["nRMSE against the ray-traced truth against volumetrics.knob"], 3);
  EXPECT_EQ(titles["volumetrics, ms against volumetrics.knob"], 3);  // two levels, and the map's
  EXPECT_EQ(titles["volumetrics, ms against pixels"], 1);
  EXPECT_EQ(titles["volumetrics, ms against lights"], 1);
  EXPECT_EQ(titles["volumetrics, ms against triangles"], 1);
  EXPECT_EQ(titles["flicker against time"], 1);
  EXPECT_EQ(titles["Time of each pass"], 2);
  EXPECT_EQ(titles["Error by kind of pixel"], 2);
  // Time was made proportional to the pixels, and to the map's side.
  EXPECT_THAT(page->text, HasSubstr("(1: proportional): exact 1.0."));
}

TEST(Content, KnobsMayBeTextsAndSwitches) {
  std::vector<json> points;
  for (const json& value : {json("average"), json("transmittance"), json(true), json(false)}) {
    json p = test::point("exact", "exact", "a", 10, 0.1);
    p["plot"] = {"knob"};
    p["knob"] = {{"id", value.is_boolean() ? "volumetrics.jitter" : "volumetrics.weights"}, {"value", value}};
    points.push_back(p);
  }
  const auto page = pageOf(resultsWith(points));
  const auto plots = page->all("svg", "plot");
  ASSERT_EQ(plots.size(), 4u);
  std::vector<std::string> labels;
  for (const std::size_t i : {0u, 2u})
    for (const Element* t : plots[i]->all("text", "tick"))
      if (t->hasClass("x")) labels.push_back(t->text);
  EXPECT_THAT(labels, testing::ElementsAre("average", "transmittance", "false", "true"));
  EXPECT_TRUE(plots[0]->all("path", "curve").empty()) << "there is nothing between two words";
}

TEST(Content, PointsThatFailedAreListedAndDrawnNowhere) {
  const auto page = pageOf(test::results());
  EXPECT_THAT(page->text,
              AllOf(HasSubstr("1 of " + std::to_string(test::results()["points"].size()) + " points have no figures"),
                    HasSubstr("min_max sees suns only")));
  for (const Element* mark : page->all("g", "mark")) EXPECT_NE(mark->attribute("data-series"), "min_max");
}

TEST(Content, EveryPointIsInTheTable) {
  const json results = test::results();
  const auto page = pageOf(results);
  const Element* table = page->all("table", "points")[0];
  const auto rows = table->all("tbody")[0]->all("tr");
  ASSERT_EQ(rows.size(), results["points"].size() - 1);
  const auto columns = table->all("thead")[0]->all("th").size();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]->children.size(), columns);
    EXPECT_EQ(std::strtod(rows[i]->children[5]->attribute("data-v").c_str(), nullptr),
              results["points"][i]["volumetrics_ms"]["median"].get<double>())
        << "exact for sorting and CSV";
  }
}

TEST(Content, WithoutATruthTheMarchIsTheReference) {
  json results = test::results();
  for (json& p : results["points"])
    if (!p["error"].is_null()) p["error"]["truth"] = nullptr;
  const auto page = pageOf(results);
  EXPECT_THAT(page->text, HasSubstr("nRMSE against the converged march"));
  EXPECT_THAT(page->text, Not(HasSubstr("nRMSE against the ray-traced truth")));
}

TEST(Content, ViewsAreNotMixed) {
  json small = test::point("exact", "exact", "a", 5, 0.2), later = small;
  small["size"] = {320, 180};
  later["seconds"] = 2;
  const auto page = pageOf(resultsWith({test::point("exact", "exact", "a", 10, 0.1), small, later}));
  EXPECT_EQ(page->all("svg", "plot").size(), 3u);
}

TEST(Content, WhatIsNoBetterThanBlackIsOnNoFront) {
  const auto page =
      pageOf(resultsWith({test::point("dark", "dark", "a", 1, 1.5), test::point("good", "good", "b", 10, 0.1)}));
  const std::string text = page->text;
  EXPECT_NE(text.find("dark"), std::string::npos) << "it is plotted";
  const std::size_t front = text.find("Pareto front: ");
  ASSERT_NE(front, std::string::npos);
  const std::string sentence = text.substr(front, 120);
  EXPECT_NE(sentence.find("good"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("dark"), std::string::npos) << sentence;
}

TEST(Content, SeriesLookDifferent) {
  std::vector<json> points;
  for (int i = 0; i < 30; ++i)
    points.push_back(
        test::point("series " + std::to_string(i), "technique " + std::to_string(i / 3), "a", 10 + i, 1.0 / (1 + i)));
  const auto page = pageOf(resultsWith(points));
  std::set<std::string> looks;
  for (const Element* li : page->all("ul", "legend")[0]->all("li")) {
    const auto paths = li->all("path");
    looks.insert(paths[0]->attribute("class") + paths[0]->attribute("stroke-dasharray") + paths[1]->attribute("d"));
  }
  EXPECT_EQ(looks.size(), 30u);
}

}  // namespace
}  // namespace tyndall::bench
