// What a series looks like, the same in every plot: colour says the technique, marker and dash tell series apart.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "results.hpp"

namespace tyndall::bench::report {

struct Style {
  int colour = 0;  ///< index of the page's --c0, --c1, ...
  int marker = 0;  ///< 0 … kMarkers - 1
  int dash = 0;    ///< 0: solid
};

inline constexpr int kColours = 10;  ///< of the page; the first nine belong to the techniques that are known
inline constexpr int kMarkers = 10;

/// Series in order of first appearance, with a style each. (marker, dash) pairs repeat only beyond 40 series.
class Styles {
 public:
  explicit Styles(const Results& results);
  Style of(const std::string& series) const;
  const std::vector<std::string>& series() const { return order_; }
  /// Those of all series that are in `some`, in the page's order.
  std::vector<std::string> inOrder(const std::set<std::string>& some) const;

 private:
  std::vector<std::string> order_;
  std::map<std::string, Style> styles_;
};

/// SVG path of a marker around (0, 0).
std::string markerPath(int marker);
/// Value of stroke-dasharray; "" for a solid line.
std::string dashes(int dash);
/// "c3": the class that sets a mark's colour.
std::string colourClass(int colour);

/// Who is who: the technique that is in none of the papers, and the plain march that everything is held against.
bool isOurs(const std::string& technique);
bool isBruteForce(const std::string& technique);

}  // namespace tyndall::bench::report
