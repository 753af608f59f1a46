// A plugin's tables as the engine's own types: copied, checked.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "host/abi.hpp"
#include "host/host.hpp"

namespace tyndall::host {

/// The functions and strings of a plugin: version checked first, then the struct copied, then required functions and
/// texts. `entry` is the exported symbol.
Result<TyPlugin> readPlugin(const void* entry);

struct PluginTables {
  std::vector<params::Parameter> parameters;
  std::vector<TechniqueInfo> techniques;
  std::uint32_t selector = TY_NONE;
};
/// Calls parameters() and techniques(); the plugin must be initialised. Choices of the selector that no technique has
/// (except "none") become "not built yet".
Result<PluginTables> readTables(const TyPlugin& plugin);

/// One row of the table; errors name the id.
Result<params::Parameter> readParameter(const TyParameter& row, const std::string& owner);

}  // namespace tyndall::host
