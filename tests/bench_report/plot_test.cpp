// Plots read back: marks, error bars, bars and fronts lie where the axes' own tick labels say.
#include <cmath>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>

#include "document.hpp"
#include "report/line_plot.hpp"
#include "report/row_chart.hpp"

namespace tyndall::bench {
namespace {

using namespace report;
using test::Element;

struct PlacedTick {
  double value, pixel;
};

/// What a reader of the axis sees: labels and where they stand.
std::vector<PlacedTick> ticks(const Element& svg, const std::string& axis) {
  std::vector<PlacedTick> all;
  for (const Element* t : svg.all("text", "tick")) {
    if (!t->hasClass(axis)) continue;
    std::string text;
    for (const char c : t->text)
      if (c != ',') text += c;
    if (const std::size_t minus = text.find("−"); minus != std::string::npos)
      text.replace(minus, std::string("−").size(), "-");
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end != 0) continue;  // a row's name
    all.push_back({value, std::strtod(t->attribute(axis).c_str(), nullptr) - (axis == "y" ? 4 : 0)});
  }
  return all;
}

/// The value at a pixel by the two outermost ticks.
double valueAt(const std::vector<PlacedTick>& t, double pixel, bool log) {
  const auto f = [&](double v) { return log ? std::log(v) : v; };
  const PlacedTick &a = t.front(), &b = t.back();
  const double x = f(a.value) + (f(b.value) - f(a.value)) * (pixel - a.pixel) / (b.pixel - a.pixel);
  return log ? std::exp(x) : x;
}

std::pair<double, double> translation(const Element& e) {
  double x = 0, y = 0;
  EXPECT_EQ(std::sscanf(e.attribute("transform").c_str(), "translate(%lf %lf)", &x, &y), 2);
  return {x, y};
}

LinePlot plotOf(Scale x, Scale y, std::vector<Mark> marks) {
  LinePlot plot;
  plot.x = {"x", x, false, {}, false};
  plot.y = {"y", y, false, {}, false};
  plot.lines.push_back({"s", {}, std::move(marks), true});
  return plot;
}

TEST(LinePlot, MarksLieWhereTheTicksSay) {
  std::mt19937 random(3);
  for (int round = 0; round < 400; ++round) {
    // Ranges from a hair to twelve decades, large and small.
    const bool log = round % 2;
    const double centre = std::uniform_real_distribution<>(-6, 6)(random),
                 span = std::uniform_real_distribution<>(0.001, log ? 12 : 2)(random);
    std::uniform_real_distribution<double> exponent(centre, centre + span);
    std::vector<Mark> marks(1 + static_cast<std::size_t>(round % 7));
    for (Mark& m : marks) {
      m.x = std::pow(10, exponent(random));
      m.y = std::pow(10, exponent(random));
      if (round % 3) m.yLow = 0.9 * m.y, m.yHigh = 1.2 * m.y;
    }
    const Scale scale = log ? Scale::kLog : Scale::kLinear;
    const std::string text = svg(plotOf(scale, scale, marks));
    const auto root = test::page(text);
    const auto xTicks = ticks(*root, "x"), yTicks = ticks(*root, "y");
    ASSERT_GE(xTicks.size(), 2u) << text;
    ASSERT_GE(yTicks.size(), 2u) << text;
    ASSERT_LE(xTicks.size(), 14u) << text;
    // All ticks lie on one line, so that no label lies.
    for (const auto* axis : {&xTicks, &yTicks})
      for (const PlacedTick& t : *axis) {
        const double reach = std::abs(axis->back().value - axis->front().value);
        ASSERT_NEAR(valueAt(*axis, t.pixel, log), t.value, 1e-3 * (log ? t.value : reach)) << text;
      }
    const auto drawn = root->all("g", "mark");
    ASSERT_EQ(drawn.size(), marks.size());
    const auto at = [&](const std::vector<PlacedTick>& t, double pixel) {
      return log ? std::log(valueAt(t, pixel, true)) : valueAt(t, pixel, false);
    };
    const auto f = [&](double v) { return log ? std::log(v) : v; };
    // Coordinates are written to 1/100 pixel: what three hundredths are worth.
    const double xWorth = std::abs(at(xTicks, 0.03) - at(xTicks, 0)) + 1e-9,
                 yWorth = std::abs(at(yTicks, 0.03) - at(yTicks, 0)) + 1e-9;
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const auto [px, py] = translation(*drawn[i]);
      EXPECT_NEAR(at(xTicks, px), f(marks[i].x), xWorth * 40) << text;
      EXPECT_NEAR(at(yTicks, py), f(marks[i].y), yWorth * 40) << text;
      const auto bars = drawn[i]->all("path", "bar");
      ASSERT_EQ(bars.size(), marks[i].yLow ? 1u : 0u);
      if (!marks[i].yLow) continue;
      double high = 0, low = 0, again = 0;
      ASSERT_EQ(std::sscanf(bars[0]->attribute("d").c_str(), "M-3 %lfH3M0 %lfV%lf", &high, &again, &low), 3);
      EXPECT_NEAR(at(yTicks, py + high), f(*marks[i].yHigh), yWorth * 40);
      EXPECT_NEAR(at(yTicks, py + low), f(*marks[i].yLow), yWorth * 40);
    }
  }
}

TEST(LinePlot, NothingLiesOutsideItsFrame) {
  const auto root = test::page(
      svg(plotOf(Scale::kLog, Scale::kLog, {{0.001, 3, 2.5, 3.9, "a", "named"}, {0.7, 800, 700, 1300, "b", "also"}})));
  const Element* frame = root->all("rect", "frame")[0];
  const auto number = [&](const Element* e, const char* key) {
    return std::strtod(e->attribute(key).c_str(), nullptr);
  };
  const double left = number(frame, "x"), top = number(frame, "y"), right = left + number(frame, "width"),
               bottom = top + number(frame, "height");
  for (const Element* mark : root->all("g", "mark")) {
    const auto [x, y] = translation(*mark);
    EXPECT_GT(x, left);
    EXPECT_LT(x, right);
    EXPECT_GT(y, top);
    EXPECT_LT(y, bottom);
  }
  for (const Element* line : root->all("line", "grid"))
    for (const char* key : {"x1", "x2"}) EXPECT_TRUE(number(line, key) >= left && number(line, key) <= right);
  ASSERT_EQ(root->all("text", "name").size(), 2u);
}

TEST(LinePlot, WhatALogarithmCannotShowIsLeftOut) {
  EXPECT_EQ(
      svg(plotOf(Scale::kLog, Scale::kLog, {{0, 1, {}, {}, "", ""}, {1, 0, {}, {}, "", ""}, {1, NAN, {}, {}, "", ""}})),
      "");
  const auto root = test::page(
      svg(plotOf(Scale::kLog, Scale::kLog, {{1, 1, {}, {}, "", ""}, {0, 2, {}, {}, "", ""}, {2, 2, 0, 3, "", ""}})));
  EXPECT_EQ(root->all("g", "mark").size(), 2u);
  EXPECT_EQ(root->all("path", "bar").size(), 0u) << "a quartile of 0 has no place";
}

TEST(LinePlot, TheFrontIsAStaircaseThroughItsPoints) {
  LinePlot plot =
      plotOf(Scale::kLinear, Scale::kLinear, {{3, 1, {}, {}, "", ""}, {2, 2, {}, {}, "", ""}, {1, 5, {}, {}, "", ""}});
  plot.front = {{3, 1}, {2, 2}, {1, 5}};
  const auto root = test::page(svg(plot));
  const auto xs = ticks(*root, "x"), ys = ticks(*root, "y");
  double right, y0, x0, x0Again, y1, x1, x1Again, y2, x2, top;
  ASSERT_EQ(
      std::sscanf(root->all("path", "front")[0]->attribute("d").c_str(), "M%lf %lfH%lfH%lfV%lfH%lfH%lfV%lfH%lfV%lf",
                  &right, &y0, &x0, &x0Again, &y1, &x1, &x1Again, &y2, &x2, &top),
      10);
  EXPECT_NEAR(valueAt(xs, x0, false), 3, 0.01);
  EXPECT_EQ(x0, x0Again);
  EXPECT_NEAR(valueAt(ys, y0, false), 1, 0.02);
  EXPECT_NEAR(valueAt(xs, x1, false), 2, 0.01);
  EXPECT_NEAR(valueAt(ys, y1, false), 2, 0.02);
  EXPECT_NEAR(valueAt(xs, x2, false), 1, 0.01);
  EXPECT_NEAR(valueAt(ys, y2, false), 5, 0.02);
}

TEST(RowChart, PartsAreAsLongAsTheirTimes) {
  RowChart chart;
  chart.title = "t";
  chart.x = {"ms", Scale::kLinear, true, {}, false};
  chart.rows = {{"first", "", {{30, 0, "a", "tip"}, {50, 1, "b", "tip"}}, {}},
                {"second", "", {{120, 0, "a", "tip"}}, {}},
                {"nothing", "", {{0, 0, "a", "tip"}}, {}}};
  const auto root = test::page(svg(chart));
  const auto t = ticks(*root, "x");
  EXPECT_EQ(t.front().value, 0);
  const auto parts = root->all("g", "part");
  ASSERT_EQ(parts.size(), 3u);
  const double expected[3][2] = {{0, 30}, {30, 80}, {0, 120}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Element* rect = parts[i]->all("rect")[0];
    const double x = std::strtod(rect->attribute("x").c_str(), nullptr),
                 w = std::strtod(rect->attribute("width").c_str(), nullptr);
    EXPECT_NEAR(valueAt(t, x, false), expected[i][0], 0.05);
    EXPECT_NEAR(valueAt(t, x + w, false), expected[i][1], 0.05);
  }
  EXPECT_EQ(root->text.find("nothing"), std::string::npos);
}

TEST(RowChart, DotsLieWhereTheTicksSay) {
  RowChart chart;
  chart.x = {"nRMSE", Scale::kLog, false, {}, false};
  chart.rows = {{"a", "", {}, {{0.013, {}, ""}, {0.4, {}, ""}, {0, {}, "not on this axis"}}}};
  const auto root = test::page(svg(chart));
  const auto t = ticks(*root, "x");
  const auto dots = root->all("g", "mark");
  ASSERT_EQ(dots.size(), 2u);
  EXPECT_NEAR(valueAt(t, translation(*dots[0]).first, true), 0.013, 1e-5);
  EXPECT_NEAR(valueAt(t, translation(*dots[1]).first, true), 0.4, 3e-4);
}

TEST(Axis, KnobTicksStandAtTheDataWhereTheyFit) {
  const auto labels = [](const std::vector<double>& values, Scale scale) {
    std::vector<std::string> found;
    const AxisMap axis({"knob", scale, false, {}, true}, values, 0, 400);
    for (const Tick& t : axis.ticks())
      if (!t.label.empty()) found.push_back(t.label);
    return found;
  };
  EXPECT_EQ(labels({256, 512, 1024, 2048}, Scale::kLog), (std::vector<std::string>{"256", "512", "1,024", "2,048"}));
  EXPECT_EQ(labels({1, 2, 3, 6}, Scale::kLinear), (std::vector<std::string>{"1", "2", "3", "6"}));
  std::vector<double> many;
  for (int i = 0; i < 200; ++i) many.push_back(i);
  EXPECT_LT(labels(many, Scale::kLinear).size(), 12u) << "round numbers where the data's own do not fit";
}

}  // namespace
}  // namespace tyndall::bench
