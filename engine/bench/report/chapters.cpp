#include "chapters.hpp"

#include <cctype>

#include "markup.hpp"
#include "text.hpp"

namespace tyndall::bench::report {

std::string figureBlock(const std::vector<std::string>& plots, const std::string& legend, const std::string& caption) {
  Markup m;
  m.open("figure").open("div", {{"class", "panels"}});
  for (const std::string& plot : plots) m.open("div").raw(plot).close();
  m.close().raw(legend);
  if (!caption.empty()) m.element("figcaption", caption);
  m.close();
  return m.take();
}

std::string anchorOf(const Level& level) {
  // Letters and digits stay, anything else becomes its code, so that different levels have different anchors.
  std::string anchor = "level-";
  for (const char c : level.name) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x80 && std::isalnum(code))
      anchor += c;
    else
      anchor += "_" + std::to_string(code) + "_";
  }
  return anchor + "-" + std::to_string(level.camera);
}

std::string levelChapter(const Context& context, const Level& level) {
  std::string body;
  const auto views = byView(inLevel(pointsOf(context.results, "error_time"), level));
  for (const auto& [view, points] : views) {
    const std::string part = errorTimePart(context, level, view, points);
    if (part.empty()) continue;
    Markup m;
    m.element("h3", "Run time against error, " + sizeText(view));
    body += m.take() + part;
  }
  body += knobsPart(context, inLevel(pointsOf(context.results, "knob"), level));
  body += temporalPart(context, inLevel(pointsOf(context.results, "motion"), level));
  if (body.empty()) return {};
  Markup m;
  m.element("h2",
            (level.name.empty() ? "Level without a name" : level.name) + ", camera " + std::to_string(level.camera),
            {{"id", anchorOf(level)}});
  return m.take() + body;
}

}  // namespace tyndall::bench::report
