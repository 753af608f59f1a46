// One parameter's widget by its type.
#pragma once

#include <optional>

#include "params/params.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

/// Draws a checkbox, slider or combo that shows `value`; the new value when the user changes it. Choices that are not
/// built are greyed out; those of an open combo are placed as "id=choice". Values typed into a slider (Ctrl+click) are
/// not checked here.
std::optional<double> parameterWidget(const params::Parameter& parameter, double value, Workspace& workspace);

/// Help as a tooltip of the item drawn last.
void parameterTooltip(const params::Parameter& parameter, bool isRead);

}  // namespace tyndall::editor
