// What may be missing is missing, and texts are hostile: the page stays whole and well-formed.
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench/report.hpp"
#include "document.hpp"
#include "report/markup.hpp"
#include "synthetic.hpp"

namespace tyndall::bench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::string htmlOf(const json& results) {
  const auto html = reportHtml(results.dump());
  EXPECT_TRUE(html) << html.error().message;
  return html ? *html : "";
}

TEST(Missing, AnySingleFieldMayBeNullOrGone) {
  const json whole = test::results();
  // Fields by their path without list positions, so that one of each kind is tried, in the first point that has it.
  std::set<std::string> tried;
  std::vector<json::json_pointer> open = {json::json_pointer("")};
  while (!open.empty()) {
    const json::json_pointer at = open.back();
    open.pop_back();
    const json& value = whole[at];
    if (value.is_structured())
      for (const auto& item : value.items())
        open.push_back(value.is_array() ? at / static_cast<std::size_t>(std::stoul(item.key())) : at / item.key());
    if (at.empty() || whole[at.parent_pointer()].is_array()) continue;
    std::string kind;
    for (const char c : at.to_string())
      if (!std::isdigit(static_cast<unsigned char>(c))) kind += c;
    if (!tried.insert(kind).second || kind == "/format" || kind == "/version" || kind == "/points") continue;
    json null = whole, gone = whole;
    null[at] = nullptr;
    gone[at.parent_pointer()].erase(at.back());
    for (const json* r : {&null, &gone}) {
      const std::string html = htmlOf(*r);
      EXPECT_EQ(test::page(html)->name, "html") << at.to_string();
      EXPECT_THAT(html, Not(HasSubstr("nan"))) << at.to_string();
    }
  }
  EXPECT_GT(tried.size(), 60u);
}

TEST(Missing, AFieldMayBeNullInAllPoints) {
  const json whole = test::results();
  for (const auto& item : whole["points"][0].items()) {
    json r = whole;
    for (json& p : r["points"]) p[item.key()] = nullptr;
    EXPECT_EQ(test::page(htmlOf(r))->name, "html") << item.key();
  }
}

TEST(Missing, NothingButTheMustsMakesAPage) {
  const auto root = test::page(htmlOf({{"format", "tyndall-bench"}, {"version", 1}, {"points", json::array()}}));
  EXPECT_THAT(root->text, HasSubstr("The file has no points."));
  EXPECT_TRUE(root->all("svg", "plot").empty());
  const auto empty = test::page(htmlOf({{"format", "tyndall-bench"}, {"version", 1}, {"points", {json::object()}}}));
  EXPECT_TRUE(empty->all("svg", "plot").empty());
}

TEST(Missing, ZeroTimesAndErrorsAreSaidNotDrawn) {
  json r = {{"format", "tyndall-bench"},
            {"version", 1},
            {"points", {test::point("a", "exact", "1", 10, 0.1), test::point("a", "exact", "2", 20, 0)}}};
  const auto root = test::page(htmlOf(r));
  EXPECT_EQ(root->all("svg", "plot")[0]->all("g", "mark").size(), 1u);
  EXPECT_THAT(root->text, HasSubstr("1 with a time or an error of 0 cannot be drawn"));
}

TEST(Extreme, NumbersOfAnySizeMakeAPage) {
  const json whole = test::results();
  for (const double extreme : {0.0, 1e-300, 1e-9, 1.0, 1e18}) {
    for (const char* field : {"volumetrics_ms", "gpu_ms", "shadow_ms", "floor_bytes", "memory_bytes", "knob", "size"})
      for (const std::size_t every : {1u, 2u}) {
        json r = whole;
        for (std::size_t i = 0; i < r["points"].size(); i += every) {
          json& value = r["points"][i][field];
          if (value.is_null()) continue;
          if (std::string(field) == "knob")
            value["value"] = extreme;
          else if (std::string(field) == "size")
            value = {std::min(1e9, std::ceil(extreme)), std::min(1e9, std::ceil(extreme))};
          else if (value.is_object())
            value = {{"median", extreme}, {"low", 0.5 * extreme}, {"high", extreme}};
          else
            value = extreme;
        }
        r["copy_gb_s"] = extreme == 1.0 ? 1e-300 : 10;
        EXPECT_EQ(test::page(htmlOf(r))->name, "html") << field << " " << extreme;
      }
    json r = whole;
    for (json& p : r["points"])
      if (!p["error"].is_null())
        for (const char* kind : {"nrmse", "p99", "maximum", "bias", "pixels"})
          p["error"]["truth"]["all"][kind] = extreme;
    for (json& l : r["levels"])
      for (const char* kind : {"triangles", "lights", "truth_samples", "truth_self_nrmse"}) l[kind] = extreme;
    EXPECT_EQ(test::page(htmlOf(r))->name, "html") << extreme;
  }
}

TEST(Extreme, DamagedTextIsAPageOrAnError) {
  const std::string whole = test::results().dump();
  std::mt19937 random(4);
  int pages = 0;
  for (int round = 0; round < 500; ++round) {
    std::string text = whole;
    const int changes = 1 + round % 3;
    for (int i = 0; i < changes; ++i) {
      // Mostly bytes that JSON is made of, so that some damage stays valid.
      const std::string bytes = "0123456789-eE.,:[]{}\"tfn \x01\xff";
      text[random() % text.size()] = bytes[random() % bytes.size()];
    }
    if (round % 10 == 0) text.resize(random() % text.size());
    const auto html = reportHtml(text);
    if (html) {
      ++pages;
      EXPECT_EQ(test::page(*html)->name, "html") << text;
    } else {
      EXPECT_THAT(html.error().message, testing::StartsWith("benchmark results: "));
      EXPECT_THAT(html.error().message, Not(HasSubstr("\n")));
    }
  }
  EXPECT_GT(pages, 40);
}

/// Every text of the file, and every setting's id, becomes hostile; but who is brute force and who is ours stays known.
void poison(json& value, const std::string& text, const std::string& key = "") {
  if (value.is_string() && key != "format" && key != "plot" && key != "owner" && value != "exact" &&
      value != "ray_march")
    value = text + value.get<std::string>();
  if (value.is_array())
    for (json& v : value)
      if (key != "plot") poison(v, text, key);
  if (!value.is_object()) return;
  for (auto& item : value.items()) poison(item.value(), text, item.key());
  if (key == "settings") {
    json poisoned;
    for (auto& item : value.items()) poisoned[text + item.key()] = item.value();
    value = poisoned;
  }
}

TEST(Hostile, TextsStayTexts) {
  const auto clean = test::page(htmlOf(test::results()));
  for (const std::string& bad :
       {std::string("<script>alert(1)</script>"), std::string("\"><img src=x onerror='alert(1)'/>"),
        std::string("]]>&amp;&#0;&unknown;"), std::string("--></style></script><b>"),
        std::string("\x01\x08\x0b\x0c\x1f\x7f\0 nul", 10), std::string("\xEF\xBF\xBE\xEF\xBF\xBF"),
        std::string("\xF0\x9F\x94\xA6 \xD7\xA9\xD7\x9C\xE2\x80\xAE"), std::string(3000, 'W')}) {
    json r = test::results();
    poison(r, bad);
    const std::string html = htmlOf(r);
    const auto root = test::page(html);
    // The same elements as of the clean page: no text became an element.
    for (const char* element : {"script", "img", "style", "svg", "tr", "b", "a", "li"})
      EXPECT_EQ(root->all(element).size(), clean->all(element).size()) << element << " " << bad.substr(0, 40);
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, Not(HasSubstr("onerror='")));
    if (bad[0] == '<' || bad[0] == '"') {
      EXPECT_THAT(root->text, HasSubstr(bad)) << "what was written is what is read";
    }
  }
}

TEST(Hostile, EscapeRoundTripsThroughTheParser) {
  std::string every;
  for (int c = 1; c < 128; ++c) every += static_cast<char>(c);
  std::string error;
  const auto root = test::parse("<a b=\"" + report::escape(every) + "\">" + report::escape(every) + "</a>", error);
  ASSERT_TRUE(root) << error;
  EXPECT_EQ(root->text.substr(root->text.find(' '), 94), every.substr(every.find(' '), 94));  // ' ' to '}'
  EXPECT_THAT(root->attribute("b"), HasSubstr("!\"#$%&'()"));
}

TEST(Page, LoadsNothingFromElsewhere) {
  const auto root = test::page(htmlOf(test::results()));
  for (const char* element : {"link", "img", "iframe", "object", "embed", "use", "image"})
    EXPECT_TRUE(root->all(element).empty()) << element;
  for (const test::Element* script : root->all("script")) EXPECT_EQ(script->attribute("src"), "");
  for (const test::Element* a : root->all("a")) EXPECT_EQ(a->attribute("href")[0], '#');
  for (const test::Element* style : root->all("style")) {
    EXPECT_THAT(style->text, Not(HasSubstr("url(")));
    EXPECT_THAT(style->text, Not(HasSubstr("@import")));
  }
}

TEST(Page, AnchorsHaveOneTargetEach) {
  json r = test::results();
  r["levels"].push_back({{"name", "a b"}, {"camera", 1}});
  r["levels"].push_back({{"name", "a_b"}, {"camera", 1}});
  const auto root = test::page(htmlOf(r));
  std::map<std::string, int> ids;
  for (const char* element : {"h2", "h3"})
    for (const test::Element* h : root->all(element))
      if (!h->attribute("id").empty()) ++ids[h->attribute("id")];
  for (const auto& [id, count] : ids) EXPECT_EQ(count, 1) << id;
  for (const test::Element* a : root->all("a"))
    EXPECT_EQ(ids.count(a->attribute("href").substr(1)), 1u) << a->attribute("href");
}

TEST(Page, IsTheSameForTheSameResults) { EXPECT_EQ(htmlOf(test::results()), htmlOf(test::results())); }

}  // namespace
}  // namespace tyndall::bench
