// The rules for one pass of a layout.
#pragma once

#include "host/layout.hpp"

namespace tyndall::host {

Result<void> checkPass(const Layout& layout, const LayoutLimits& limits, const LayoutContext& context,
                       const LayoutPass& pass);

}  // namespace tyndall::host
