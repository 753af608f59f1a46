// The part of a layout that every technique on rectified rows starts with: slices and the rectified maps.
#pragma once

#include "layout_builder.hpp"
#include "stages/rectified.h"
#include "technique.hpp"

namespace volumetrics {

using namespace tyndall::shared;

/// Uniform blocks of every technique on rows, in this order: a RectifiedBlock a frame, a RectifiedSunBlock a sun.
constexpr std::uint32_t kFrameBlock = 0, kSunBlock = 1;

/// How finely a technique wants its rectified depths stored.
enum class DepthBits { k16, k32 };

/// Indices of what the stage made in the layout.
struct RectifyStage {
  std::uint32_t sliceBuffer = TY_NONE;
  std::uint32_t rectified = TY_NONE;   ///< resampled map
  std::uint32_t projective = TY_NONE;  ///< rasterised maps, one layer a split; the resampled one where there are none
  std::uint32_t slices = 0;
  std::uint32_t rows = 0;              ///< columns of all splits: height of what is made of the maps
  bool filtered = false;               ///< texels of the resampled map hold two depths
};

/// Adds both blocks, passes "slices", "rectify" and, unless the rectification is epipolar alone, "rectify linear", once per sun.
/// `filterable`: the technique can take two depths a texel (volumetrics.filtered_resampling).
RectifyStage addRectify(const LayoutContext& context, LayoutBuilder& builder, DepthBits bits, bool filterable);
/// Adds the two uniform blocks of addRectify(), which comes after, and the constants of stages/rows.glsl.
void addRowBlocks(const Settings& settings, LayoutBuilder& builder);

/// Fills both blocks but for the technique's own fields, and skips the passes of the rectification that this frame does not use.
void prepareRectify(const FrameContext& context);

/// Ids of the parameters that the stage and stages/rays_on_rows.glsl read, for a technique's list.
#define TY_RECTIFY_READS                                                                                                   \
  "volumetrics.enabled", "volumetrics.technique", "volumetrics.placement", "volumetrics.rectification",                    \
      "volumetrics.splits", "volumetrics.depth_warp", "volumetrics.columns", "volumetrics.slices",                         \
      "volumetrics.slice_spacing", "volumetrics.row_filter", "volumetrics.epipole_block", "volumetrics.near_correction",   \
      "medium.sigma_t", "medium.albedo", "medium.g"

}  // namespace volumetrics
