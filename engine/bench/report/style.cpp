#include "style.hpp"

#include <algorithm>
#include <array>

namespace tyndall::bench::report {
namespace {

/// Fixed places, so that a technique has the same colour in every report. 0 is vermilion, 1 the text's grey.
constexpr std::array<const char*, 9> kKnown = {"exact",   "ray_march",         "fourier", "moments4",     "moments6",
                                               "min_max", "epipolar_sampling", "froxel",  "shadow_volume"};

}  // namespace

Styles::Styles(const Results& results) {
  std::map<std::string, int> colours, seriesOfTechnique;
  int next = static_cast<int>(kKnown.size());
  for (const Point& p : results.points) {
    if (styles_.count(p.series)) continue;
    const std::string technique = p.technique.empty() ? p.series : p.technique;
    if (!colours.count(technique)) {
      const auto known = std::find(kKnown.begin(), kKnown.end(), technique);
      colours[technique] = known != kKnown.end() ? static_cast<int>(known - kKnown.begin()) : next++ % kColours;
    }
    const int n = static_cast<int>(order_.size());
    styles_[p.series] = {colours[technique], n % kMarkers, seriesOfTechnique[technique]++ % 4};
    order_.push_back(p.series);
  }
}

Style Styles::of(const std::string& series) const {
  const auto found = styles_.find(series);
  return found == styles_.end() ? Style{} : found->second;
}

std::vector<std::string> Styles::inOrder(const std::set<std::string>& some) const {
  std::vector<std::string> order;
  for (const std::string& s : order_)
    if (some.count(s)) order.push_back(s);
  return order;
}

std::string markerPath(int marker) {
  switch (marker) {
    case 0: return "M-4.2 0a4.2 4.2 0 1 0 8.4 0a4.2 4.2 0 1 0 -8.4 0Z";     // circle
    case 1: return "M-3.8 -3.8H3.8V3.8H-3.8Z";                              // square
    case 2: return "M0 -5L4.7 3.6H-4.7Z";                                   // triangle
    case 3: return "M0 -5.4L4.6 0L0 5.4L-4.6 0Z";                           // diamond
    case 4: return "M0 5L4.7 -3.6H-4.7Z";                                   // triangle, down
    case 5: return "M-1.6 -5H1.6V-1.6H5V1.6H1.6V5H-1.6V1.6H-5V-1.6H-1.6Z";  // plus
    case 6: return "M0 -5.2L4.9 -1.6L3.1 4.2H-3.1L-4.9 -1.6Z";              // pentagon
    case 7:
      return "M-4.6 -2.4L-2.4 -4.6L0 -2.2L2.4 -4.6L4.6 -2.4L2.2 0L4.6 2.4L2.4 4.6L0 2.2L-2.4 4.6L-4.6 2.4L-2.2 0Z";  // cross
    case 8: return "M0 -5.8L1.5 -1.9L5.5 -1.8L2.3 0.7L3.4 4.7L0 2.4L-3.4 4.7L-2.3 0.7L-5.5 -1.8L-1.5 -1.9Z";  // star
    default: return "M-5 -2.2H5V2.2H-5Z";                                                                     // bar
  }
}

std::string dashes(int dash) {
  switch (dash) {
    case 1: return "7 3";
    case 2: return "2 3";
    case 3: return "8 3 2 3";
    default: return "";
  }
}

std::string colourClass(int colour) { return "c" + std::to_string(colour); }

bool isOurs(const std::string& technique) { return technique == "exact"; }
bool isBruteForce(const std::string& technique) { return technique == "ray_march"; }

}  // namespace tyndall::bench::report
