// The part of a layout that every technique on rectified rows starts with: slices and the rectified maps.
#pragma once

#include "layout_builder.hpp"
#include "stages/rectified.h"
#include "technique.hpp"

namespace volumetrics {

using namespace tyndall::shared;

/// Uniform blocks of every technique on rows, in this order: a RectifiedBlock a frame, a RectifiedLightBlock a light.
constexpr std::uint32_t kFrameBlock = 0, kLightBlock = 1;
/// The LocalBlock of each spot or point light by itself, for the dense march of debug views.
constexpr std::uint32_t kLocalBlock = 2;
/// The CookieBlock of each light by itself, likewise.
constexpr std::uint32_t kCookieBlock = 3;
/// With rectification=auto or linear, the RectifiedLightBlock of a sun's second map while one map fades into the other.
constexpr std::uint32_t kFadingBlock = 4;

/// Lights that the same passes serve: suns, or spot and point lights, with a cookie or without. In each frame the
/// passes of other classes are left out for a light.
struct LightClass {
  bool local = false;
  bool shaped = false;    ///< light rays differ in strength: cones, cookies
  bool coloured = false;  ///< they have a cookie
  bool fading =
      false;  ///< the second maps of suns between two rectifications: added to the result, and left out of most frames
};
/// Whether a layout has passes for second maps: a rectification that may be projective, and a sun without a cookie. The
/// result must then be cleared and added to.
bool mayFade(const LayoutContext& context);
/// The classes of a layout's lights. For each, begin with beginClass() and add all passes; images are shared.
std::vector<LightClass> lightClasses(const LayoutContext& context);
/// Columns of all splits that rows of a class have.
std::uint32_t rowsOf(const Settings& settings, const LightClass& lights);
/// Directs passes for kEachLight to the class, and sets the constants of stages/rows.glsl.
void beginClass(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights);

/// How finely a technique wants its rectified depths stored.
enum class DepthBits { k16, k32 };

/// Indices of what the stage made in the layout.
struct RectifyStage {
  std::uint32_t sliceBuffer = TY_NONE;
  std::uint32_t rectified = TY_NONE;   ///< resampled map
  std::uint32_t projective = TY_NONE;  ///< rasterised maps, one layer a split; the resampled one where there are none
  std::uint32_t slices = 0;
  std::uint32_t rows = 0;  ///< columns of all splits: height of what is made of the maps
  bool filtered = false;   ///< texels of the resampled map hold two depths
  LightClass lights;
  std::uint32_t weights =
      TY_NONE;  ///< of columns (stages/shine.comp.glsl); where light rays do not differ, the resampled map as stand-in
  std::uint32_t lit = TY_NONE;         ///< answers of lit rays (stages/lit.comp.glsl); likewise
  std::uint32_t unshadowed = TY_NONE;  ///< table of spot and point lights (stages/unshadowed.comp.glsl); likewise
};

/// The bindings of what evaluation and prefix read where light rays differ or the light is near: 20 weights, 21 table,
/// 22 lit.
TyBinding weightsAt20(const RectifyStage& stage);
TyBinding unshadowedAt21(const RectifyStage& stage);
TyBinding litAt22(const RectifyStage& stage);
/// The result, for the pass that evaluates a class.
TyBinding resultAt5(const LightClass& lights, bool add);

/// Adds, once per light of the class, "slices", "rectify" and, for suns unless the rectification is epipolar alone,
/// "rectify linear"; for spot and point lights "unshadowed"; where light rays differ "shine" and "lit". `filterable`:
/// the technique can take two depths a texel (volumetrics.filtered_resampling; suns only). `weighted`: columns get
/// weights for reference rays; otherwise "shine" and "lit" are left to the technique.
RectifyStage addRectify(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights, DepthBits bits,
                        bool filterable, bool weighted = true);
/// Adds the uniform blocks of addRectify(), which comes after.
void addRowBlocks(const LayoutContext& context, LayoutBuilder& builder);

/// Fills both blocks but for the technique's own fields, and skips the passes of the rectification that this frame does
/// not use, and all of spot and point lights that reach no view ray. `parted`: the prefix starts anew in every region
/// and split.
void prepareRectify(const FrameContext& context, bool parted = true);

/// Ids of the parameters that the stage and stages/rays_on_rows.glsl read, for a technique's list.
#define TY_RECTIFY_READS                                                                                \
  "volumetrics.enabled", "volumetrics.technique", "volumetrics.placement", "volumetrics.rectification", \
      "volumetrics.splits", "volumetrics.depth_warp", "volumetrics.columns", "volumetrics.slices",      \
      "volumetrics.slice_spacing", "volumetrics.column_spacing", "volumetrics.row_filter",              \
      "volumetrics.epipole_block", "volumetrics.near_correction", "medium.sigma_t", "medium.albedo", "medium.g"

}  // namespace volumetrics
