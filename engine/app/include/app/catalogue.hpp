// The loaded plugins and the one parameter table of engine and plugins. Needs no GPU.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "host/host.hpp"
#include "params/params.hpp"

namespace tyndall::app {

/// `asked` if given, else $TYNDALL_PLUGIN_DIR if set, else <folder of the executable>/plugins.
std::filesystem::path pluginFolder(const std::filesystem::path& asked);

class Catalogue {
 public:
  /// Loads every plugin in `folder`. One of them is the effect: "volumetrics" if it is there, else the only plugin that
  /// is. Errors: no plugin (the folder searched is named), or the effect itself could not be loaded (its reason).
  static Result<std::unique_ptr<Catalogue>> load(const std::filesystem::path& folder);

  params::Table& table() { return table_; }
  const params::Table& table() const { return table_; }
  const std::vector<std::unique_ptr<host::Plugin>>& plugins() const { return plugins_; }
  host::Plugin& effectPlugin() const { return *plugins_[effect_]; }
  /// Plugins that could not be loaded beside the effect, one line each.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// The technique chosen in the table, or null when the choice is "none" or the plugin has no selector.
  const host::TechniqueInfo* technique() const;
  /// The selector's value as text ("moments6", "none"); the plugin's id when it has no selector.
  std::string techniqueName() const;
  /// Whether anything reads moment shadow maps: surfaces (shadows.mode) or the technique (filtered_resampling).
  bool readsShadowMoments() const;
  /// Ids set explicitly that the chosen technique does not read.
  std::vector<std::string> unusedSettings() const;

  /// Takes a freshly loaded effect plugin in place of the present one; values are kept. On an error nothing changes.
  Result<void> replaceEffectPlugin(std::unique_ptr<host::Plugin> plugin);

 private:
  Catalogue() = default;
  params::Table table_;
  std::vector<std::unique_ptr<host::Plugin>> plugins_;
  std::vector<std::string> warnings_;
  std::size_t effect_ = 0;
};

}  // namespace tyndall::app
