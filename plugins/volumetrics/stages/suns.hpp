// How techniques that go sun by sun share the result image: with one sun its pass writes it; otherwise a clearing pass starts
// it and every sun adds to it.
#pragma once

#include "layout_builder.hpp"
#include "technique.hpp"

namespace volumetrics {

inline std::uint32_t groups8(std::uint32_t size) { return (size + 7) / 8; }

/// Adds the clearing pass where it is needed. `frameBlock` is a uniform block that starts with a RayBlock. Returns true if the
/// suns' passes must add (specialization constant kFirstLight = false).
inline bool beginSuns(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock) {
  if (context.directionalLights == 1) return false;
  builder.compute({"clear", "clear.comp",
                   {uniformAt(0, frameBlock), sceneDepthAt(1), outputAt(2, TY_ACCESS_STORAGE_WRITE)},
                   groups8(context.structure.width), groups8(context.structure.height), 1, false, {}});
  return true;
}

}  // namespace volumetrics
