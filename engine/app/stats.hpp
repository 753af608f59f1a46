// The reports of the command line: JSON for programs, a table for people.
#pragma once

#include <string>
#include <vector>

#include "render_run.hpp"

namespace tyndall::app {

/// --stats: see README.md for the keys.
std::string statsJson(const RenderOptions& options, Session& session, const RenderRun& run,
                      const std::vector<std::string>& notes);
/// Device, size, passes with their times, total.
std::string statsTable(const RenderOptions& options, Session& session, const RenderRun& run);
/// describe: plugins, techniques, parameters, debug views.
struct DebugViewText {
  std::string name, owner, doc;
  std::vector<std::string> techniques;  ///< of the effect, that have the view; empty: there whatever the technique
};
/// What the effect's technique makes of parameters on automatic on this device, as far as it was measured ("" where
/// not).
struct AutomaticText {
  std::string technique, parameter, value;
};
std::string describeJson(const Catalogue& catalogue, const std::vector<DebugViewText>& views,
                         const std::vector<AutomaticText>& automatics);

}  // namespace tyndall::app
