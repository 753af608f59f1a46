// Debug views that every technique has, or every technique on rows. Their passes run only in frames that show them: a
// host leaves out passes whose results nobody reads.
#pragma once

#include "stages/rectify.hpp"

namespace volumetrics {

/// View "difference": the result minus a dense march of every light through its shadow map, absolute. `frameBlock` is a
/// uniform block that starts with a RayBlock, `sunBlock` a per-light one that starts with a SunBlock, `localBlock` one
/// that starts with a LocalBlock (TY_NONE: spot and point lights are left out), `cookieBlock` one of CookieBlocks. To
/// be called after the passes of the technique.
void addDifferenceView(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock,
                       std::uint32_t sunBlock, std::uint32_t localBlock, std::uint32_t cookieBlock);

/// Views "slice", "inclination", "reference_ray_error" per pixel and "weights" of the columns.
void addRowViews(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage);

/// The layout of a technique on rows that scatters lights of all kinds: blocks, clearing, what `addClass` adds for each
/// class of lights (`add`: to what other lights have scattered), and the difference view.
void addRowLayout(const LayoutContext& context, LayoutBuilder& builder,
                  void (*addClass)(const LayoutContext&, LayoutBuilder&, const LightClass&, bool add));

}  // namespace volumetrics
