// The reports of the command line: JSON for programs, a table for people.
#pragma once

#include <string>
#include <vector>

#include "render_run.hpp"

namespace tyndall::app {

/// --stats: see README.md for the keys.
std::string statsJson(const RenderOptions& options, Session& session, const RenderRun& run, const std::vector<std::string>& notes);
/// Device, size, passes with their times, total.
std::string statsTable(const RenderOptions& options, Session& session, const RenderRun& run);
/// describe: plugins, techniques, parameters, debug views.
struct DebugViewText {
  std::string name, owner, doc;
  std::vector<std::string> techniques;  ///< of the effect, that have the view; empty: there whatever the technique
};
std::string describeJson(const Catalogue& catalogue, const std::vector<DebugViewText>& views);

}  // namespace tyndall::app
