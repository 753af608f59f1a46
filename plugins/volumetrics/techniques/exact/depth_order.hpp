// Layout of rows in the order of depth (volumetrics.row_order=depth).
#pragma once

#include "stages/rectify.hpp"

namespace volumetrics {

/// Adds the passes for one class of lights. `add`: the result is added to.
void addDepthOrder(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights, bool add);
/// How rows are built: by an invocation each, or, where shared memory holds a row, by a workgroup.
void addDepthOrderTunable(const LayoutContext& context, LayoutBuilder& builder);

}  // namespace volumetrics
