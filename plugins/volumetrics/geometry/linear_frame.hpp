// The projective ("linear") rectification of a directional light (Klehm et al. 2014, section 4.2): a perspective along
// the 2D bisectrix of the view with the eye as its centre turns view rays into rows, so casters are rasterised straight
// into the map. Deviation: its extent along the bisectrix is cut to where light can be blocked at all (frustum and
// casters, seen along the light).
#pragma once

#include <optional>

#include "geometry/epipolar_frame.hpp"

namespace volumetrics {

struct LinearFrame {
  RectificationBlock block{};
  /// Of each split: x runs over slices, y over the split's columns, z is the normalised depth, w the distance along e1.
  std::array<glm::mat4, kMaxSplits> clipFromWorld{};
  /// Length along e1 of the longest column, the last of each split, and of one if as many as all maps have were all
  /// equal, as in the epipolar map that stands in for them, m (0: nothing can be blocked).
  double longestColumn = 0, evenColumn = 0;
  /// Angle of the widest slice, in the middle, over that of one if all were equal.
  double widestSlice = 1;
  /// Condition: the least length along e1 of the unit directions to the screen's corners. It falls to 0 where no
  /// projective map exists: a corner looks along the light, or the view spans half a circle. Slices are at most some
  /// 1/condition as wide as even ones, depths span at most 2/condition, and columns begin at condition times znear.
  double condition = 1;
  /// The longest column of all, the last of each split, over the length of all together: at 1 a map has one column.
  double longestShare = 0;
};

/// Borders along e1, m, of `splits` maps over [first, last], 0 < first < last, whose last columns, of `columns` each,
/// are of one length, the shortest possible: the first maps grow fastest. Entries 0 to `splits`.
std::array<double, kMaxSplits + 1> splitBorders(double first, double last, std::uint32_t splits, double columns);

/// None where no projective map exists: the light or its antipode is in view, or the view spans (nearly) 180 degrees
/// seen along the light. `splits` is 1...4; their borders make the last columns of all as short as they can be.
std::optional<LinearFrame> linearFrame(const RectificationInput& input, std::uint32_t splits);

/// The share of the light, 0...1, that the projective map can answer for at all, which is the rule of
/// rectification=linear: all, but where the map is so ill-conditioned, or has so much of its length in one column, that
/// the epipolar one has to take over. Between, a camera turns some degrees, in which one map fades into the other.
double linearHold(const LinearFrame& frame);

/// The rule of rectification=auto: the share of the light, 0...1, that the projective map answers for. None if the last
/// column of a split is longer than four epipolar ones or a slice wider than 1.4; all if they are well below; between,
/// in which a camera turns some six degrees, one map fades into the other. Slices come first when the light nears the
/// screen: seen along it, the view then spans nearly half a circle.
double linearShare(const LinearFrame& frame);

}  // namespace volumetrics
