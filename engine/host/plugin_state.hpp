// What a loaded plugin holds.
#pragma once

#include <mutex>

#include "call_watch.hpp"
#include "host/host.hpp"
#include "library.hpp"
#include "plugin_tables.hpp"

namespace tyndall::host {

/// Where a plugin's log lines go: what TyHost.context points to. Warnings and errors of a call that may be refused wait
/// for its end, to become part of the refusal, which is one line.
class PluginLog {
 public:
  std::string prefix;  ///< "volumetrics: "
  void line(std::uint32_t level, const std::string& text);
  void hold();
  /// The call succeeded: its lines go where others do.
  void letGo();
  /// The call failed: its lines as a reason, ": first; second", or that there is none.
  std::string reason();

 private:
  struct Line {
    std::uint32_t level;
    std::string text;
  };
  std::mutex mutex_;
  bool holding_ = false;
  std::vector<Line> held_;
};

struct Plugin::State {
  ~State();

  /// For messages: "plugin 'volumetrics'".
  std::string called() const { return "plugin '" + id + "'"; }
  TyInstance* create();
  void destroy(TyInstance* made);

  std::filesystem::path path;
  std::unique_ptr<Library> library;  ///< outlives every call into the plugin: see the destructor
  std::string id, name, version, doc;
  PluginLog log;
  TyHost host{};
  TyPlugin plugin{};
  bool initialised = false;
  TyInstance* instance = nullptr;
  PluginTables tables;
};

}  // namespace tyndall::host
