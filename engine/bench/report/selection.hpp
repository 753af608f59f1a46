// Which points belong together, what they are called, and what a reader sees over one.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/curves.hpp"
#include "results.hpp"
#include "style.hpp"

namespace tyndall::bench::report {

using Points = std::vector<const Point*>;

/// What every chapter is made from.
struct Context {
  const Results& results;
  const Styles& styles;
};

/// What must be equal for times and errors to be compared: the picture.
struct View {
  std::string level;
  int camera = 0;
  Number seconds;
  int width = 0, height = 0;
  friend bool operator==(const View&, const View&) = default;
};

View viewOf(const Point& p);
std::string sizeText(int width, int height);  ///< "1280×720", "?" when not given
std::string sizeText(const View& view);       ///< with the time of the animations
std::string nameOf(const Point& p);           ///< series and label

/// Points measured for a plot family, not failed, in the file's order.
Points pointsOf(const Results& results, const std::string& plot);
/// The views of these points, in order of appearance, each with its points.
std::vector<std::pair<View, Points>> byView(const Points& points);
/// The series of these points, in the page's order, each with its points: by the knob's value where all have one number
/// of the same knob, else by time.
std::vector<std::pair<std::string, Points>> bySeries(const Points& points, const Styles& styles);
Points inLevel(const Points& points, const Level& level);

/// Against what errors are read: the ray-traced truth, or the converged march when a view has no truth.
enum class Reference { kTruth, kMarch };
Reference referenceOf(const Points& points);
const char* referenceName(Reference reference);
const Split& split(const Point& p, Reference reference);
/// Error over all pixels, if the point has one.
Number errorOf(const Point& p, Reference reference);
Number timeOf(const Point& p);  ///< the plugin's median, ms

/// Those points that have a time and an error.
Points measuredOf(const Points& points, Reference reference);
/// The least error, over the mean of the reference, that a black picture can have: the mean square is no less than the
/// mean's square.
inline constexpr double kBlack = 1;
/// Cost and error of those points that have both and are better than a black picture; `which` (if given) receives the
/// points.
std::vector<CostError> costErrors(const Points& points, Reference reference, Points* which = nullptr);

/// Everything about a point in a few lines.
std::string tipOf(const Point& p, Reference reference);

/// Largest distance of a quartile from its median, over the median: the noise of these points' times.
double noise(const Points& points);

}  // namespace tyndall::bench::report
