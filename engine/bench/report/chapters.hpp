// The parts of the page. Each returns finished markup, "" where the results have nothing for it.
#pragma once

#include <string>

#include "selection.hpp"

namespace tyndall::bench::report {

using Contents = std::vector<std::pair<std::string, std::string>>;  ///< anchor and title of each chapter that is there
/// What was measured, how, what to mind, and where in the page it is.
std::string headChapter(const Context& context, const Contents& contents);
std::string levelChapter(const Context& context, const Level& level);  ///< all of the plots of one level and camera
std::string scalingChapter(const Context& context);  ///< time against resolution, map, lights, triangles
std::string papersChapter(const Context& context);   ///< the papers' tables, theirs beside ours
std::string pointsChapter(const Context& context);   ///< every point, and those that failed

// Parts of a level's chapter, for the points of one view (error and time) or of the level (the rest).
std::string errorTimePart(const Context& context, const Level& level, const View& view, const Points& points);
std::string equalTables(const Context& context, const Points& points, Reference reference);
std::string breakdownPart(const Context& context, const Points& points, Reference reference);
std::string knobsPart(const Context& context, const Points& points);
std::string temporalPart(const Context& context, const Points& points);

/// A figure: the plots side by side where there is room, a legend, a caption.
std::string figureBlock(const std::vector<std::string>& plots, const std::string& legend, const std::string& caption);
/// The anchor of a level's chapter.
std::string anchorOf(const Level& level);

/// The whole page around the chapters.
std::string page(const std::string& title, const std::string& body);

}  // namespace tyndall::bench::report
