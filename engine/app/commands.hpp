// The commands of `tyndall`. Results go to stdout, everything else to stderr.
#pragma once

#include "base/result.hpp"
#include "options.hpp"

namespace tyndall::app {

Result<void> runRender(const RenderOptions& options);
Result<void> runTruth(const TruthOptions& options);
Result<void> runDescribe(const DescribeOptions& options);
Result<void> runLevels(const LevelsOptions& options);
/// Replaces this program by the editor; returns only on an error.
Result<void> runEdit(const EditOptions& options);

}  // namespace tyndall::app
