// Layout of the weighted prefix averages (stages/prefix.glsl) and of their look-up (stages/prefix_lookup.glsl).
#pragma once

#include "stages/rectify.hpp"

namespace volumetrics {

/// Levels of a prefix image with mips (kMipLevels in stages/prefix_lookup.glsl).
constexpr std::uint32_t kPrefixMips = 4;

/// What a technique adds to the shared passes.
struct PrefixTechnique {
  const char* prefixShader;
  const char* evaluateShader;
  std::uint32_t vectors = 1;  ///< vectors of four that one invocation averages
  std::uint32_t groups = 1;   ///< groups of basis functions, each averaged by its own invocations
  bool compensated = false;   ///< averages keep what rounding to float drops: for storage finer than their drift
  std::vector<TySpecialization> prefixConstants, evaluateConstants;  ///< ids 0, 2 and 4
  std::vector<std::uint32_t>
      images;                    ///< written at bindings 6, 7, ... of the prefix; read at 7, 8, ... of the evaluation
  std::vector<TyBinding> extra;  ///< further bindings of the prefix
};

/// An image for a technique's prefix, with mips if volumetrics.row_filter asks for them.
std::uint32_t prefixImage(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage,
                          const char* name, TyFormat format, std::uint32_t layers);
/// A single texel to bind where a specialization never reads it.
std::uint32_t unusedImage(LayoutBuilder& builder, const char* name, TyFormat format);

/// Adds "prefix", mips, "evaluate", the debug views of bounds, and the prefix scheme as a tunable. `add`: several suns.
void addPrefix(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage,
               const PrefixTechnique& technique, bool add);

/// Ids of the parameters that a prefix reads besides TY_RECTIFY_READS.
#define TY_PREFIX_READS                                                                                          \
  "volumetrics.reference_rays", "volumetrics.reference_ray", "volumetrics.weights", "volumetrics.prefix_bounds", \
      "volumetrics.prefix_scheme", "volumetrics.regions", "volumetrics.filtered_resampling"

}  // namespace volumetrics
