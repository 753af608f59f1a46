// The part of a layout that every technique on rectified rows starts with: slices and the rectified map.
#pragma once

#include "layout_builder.hpp"
#include "stages/rectified.h"
#include "technique.hpp"

namespace volumetrics {

using namespace tyndall::shared;

/// Indices of what the stage made in the layout.
struct RectifyStage {
  std::uint32_t sliceBuffer = TY_NONE;
  std::uint32_t rectified = TY_NONE;
};

/// Adds passes "slices" and "rectify", once per sun. Blocks: `frameBlock` holds a RectifiedBlock, `sunBlock` a RectifiedSunBlock.
RectifyStage addRectify(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock, std::uint32_t sunBlock,
                        TyFormat format);

/// Fills both blocks but for the technique's own fields.
void prepareRectify(const FrameContext& context, std::uint32_t frameBlock, std::uint32_t sunBlock);

/// Ids of the parameters that the stage reads, for a technique's list.
#define TY_RECTIFY_READS                                                                                                   \
  "volumetrics.enabled", "volumetrics.technique", "volumetrics.placement", "volumetrics.rectification",                    \
      "volumetrics.columns", "volumetrics.slices", "volumetrics.slice_spacing", "volumetrics.reference_rays",              \
      "volumetrics.reference_ray", "volumetrics.weights", "volumetrics.prefix_bounds", "volumetrics.prefix_scheme",        \
      "volumetrics.row_filter", "volumetrics.filtered_resampling", "medium.sigma_t", "medium.albedo", "medium.g"

}  // namespace volumetrics
