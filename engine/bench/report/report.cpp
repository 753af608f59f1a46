#include "bench/report.hpp"

#include "chapters.hpp"

namespace tyndall::bench {

Result<std::string> reportHtml(const std::string& resultsJson) {
  auto results = report::readResults(resultsJson);
  if (!results) return results.error();
  const report::Styles styles(*results);
  const report::Context context = {*results, styles};
  // Chapter by chapter, with an entry in the list of contents for each that has something.
  std::string body;
  report::Contents contents;
  const auto add = [&](const std::string& chapter, const std::string& anchor, const std::string& title) {
    if (chapter.empty()) return;
    if (!anchor.empty()) contents.emplace_back(anchor, title);
    body += chapter;
  };
  for (const report::Level& level : results->levels)
    add(report::levelChapter(context, level), report::anchorOf(level),
        level.name + ", camera " + std::to_string(level.camera));
  add(report::scalingChapter(context), "scaling", "Scaling");
  add(report::papersChapter(context), "papers", "The papers' tables");
  add(report::pointsChapter(context), "points", "All points");
  const std::string title = "Benchmark" + (results->sweep.empty() ? "" : " " + results->sweep) +
                            (results->device.empty() ? "" : " on " + results->device);
  return report::page(title, report::headChapter(context, contents) + body);
}

}  // namespace tyndall::bench
