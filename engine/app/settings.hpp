// Applies presets and assignments to a catalogue's table.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/catalogue.hpp"
#include "options.hpp"

namespace tyndall::app {

/// Loads the plugins, then the preset, then the assignments in their order.
Result<std::unique_ptr<Catalogue>> loadSettings(const SettingsOptions& options);

/// "tyndall: warning: <line>" and "tyndall: note: <line>" on stderr. Commands call this at their end only: a call that
/// fails says one line, the failure.
void tell(const std::vector<std::string>& warnings, const std::vector<std::string>& notes);
/// The text in one line: control characters (line feeds in a file's name, say) become '?'.
std::string oneLine(std::string text);

}  // namespace tyndall::app
