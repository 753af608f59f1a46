// How techniques that go light by light share the result image: with one light its pass writes it; otherwise a clearing
// pass starts it and every light adds to it.
#pragma once

#include "layout_builder.hpp"
#include "technique.hpp"

namespace volumetrics {

inline std::uint32_t groups8(std::uint32_t size) { return (size + 7) / 8; }

inline std::uint32_t clearResult(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock) {
  return builder.compute({"clear",
                          "clear.comp",
                          {uniformAt(0, frameBlock), sceneDepthAt(1), outputAt(2, TY_ACCESS_STORAGE_WRITE)},
                          groups8(context.structure.width),
                          groups8(context.structure.height),
                          1,
                          0,
                          {}});
}

/// Adds the clearing pass where it is needed. `frameBlock` is a uniform block that starts with a RayBlock. Returns true
/// if the suns' passes must add (specialization constant kFirstLight = false). `twice`: a sun may have two maps, which
/// share its light.
inline bool beginSuns(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock,
                      bool twice = false) {
  if (context.directionalLights == 1 && !twice) return false;
  clearResult(context, builder, frameBlock);
  return true;
}

/// The same for techniques that scatter lights of every kind. If the only light is a local one, the clearing pass
/// stands by for frames in which prepareLocalLights() leaves that light out; passes of local lights bind the result for
/// reading and writing.
inline bool beginLights(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock,
                        bool twice = false) {
  const std::uint32_t lights = context.structure.light_count;
  if (lights == 1 && context.directionalLights == 1 && !twice) return false;
  const std::uint32_t clear = clearResult(context, builder, frameBlock);
  if (lights == 1 && !twice) builder.roles().standInClear = clear;
  return lights != 1 || twice;
}

}  // namespace volumetrics
