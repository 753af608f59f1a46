// What a loaded plugin holds.
#pragma once

#include "host/host.hpp"
#include "library.hpp"
#include "plugin_tables.hpp"

namespace tyndall::host {

struct Plugin::State {
  ~State();

  std::filesystem::path path;
  std::unique_ptr<Library> library;  ///< outlives every call into the plugin: see the destructor
  std::string id, name, version, doc;
  std::string logPrefix;  ///< what TyHost.context points to
  TyHost host{};
  TyPlugin plugin{};
  bool initialised = false;
  TyInstance* instance = nullptr;
  PluginTables tables;
};

}  // namespace tyndall::host
