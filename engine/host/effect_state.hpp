// What a PluginEffect keeps between frames.
#pragma once

#include <set>
#include <deque>
#include <optional>

#include "base/file.hpp"
#include "built.hpp"
#include "plugin_state.hpp"
#include "tuner.hpp"

namespace tyndall::host {

struct PluginEffect::State {
  State(gpu::Device& d, Plugin& p, const params::Table& t)
      : device(d),
        plugin(p),
        table(t),
        pipelines(d, p.path().parent_path() / p.id()),
        tuner(TunerStore(cacheFolder().empty() ? std::filesystem::path{} : cacheFolder() / "tunables.json")) {}

  /// A tunable whose parameter is on automatic, in the layout for the structure that was asked for.
  struct Automatic {
    std::string key;
    LayoutTunable tunable;
  };
  /// What is known of a frame whose passes were declared, until frameFinished() tells of it.
  struct Pending {
    std::shared_ptr<Built> built;  ///< null: nothing ran
    std::shared_ptr<const FrameRefs> refs;
    std::uint32_t slot = 0;
    std::string timedKey;  ///< the tunable that this frame times, or ""
    std::set<std::uint32_t> timedLights;
    std::size_t timedVariant = 0;
    std::vector<std::string> timedPasses;
  };

  Result<Layout> ask(const Structure& structure);
  /// A layout for the table's values, a picture and a sun as they might be; nothing is made from it.
  Result<Layout> preview(Structure& structure);
  /// The tunables of a layout whose parameters are on automatic.
  std::vector<Automatic> automaticsOf(const Structure& wanted, const Layout& layout) const;
  Result<void> build(Structure structure, bool castersOffered);
  Result<void> update(const Structure& asked, bool castersOffered);
  bool prepare(const render::EffectInput& input, const Structure& asked);
  void resolve(Structure& structure);
  /// The last prepare() left out a run of one of these passes: a frame that times nothing of them.
  /// Lights (TY_NONE: of passes that are not per light) that runs of these passes were recorded for in the frame being built.
  std::set<std::uint32_t> lightsOf(const std::vector<std::string>& passes) const;

  gpu::Device& device;
  Plugin& plugin;
  const params::Table& table;
  Pipelines pipelines;
  Tuner tuner;

  std::optional<Structure> asked;  ///< what `automatics`, `built` and `failure` belong to
  std::vector<Automatic> automatics;
  std::shared_ptr<Built> built;
  std::optional<Error> failure;
  bool reset = true;  ///< no prepare() has succeeded since the last cut or new layout
  std::uint64_t frame = 0;
  std::deque<Pending> pending;
  std::shared_ptr<const FrameRefs> refs;  ///< of the last addPasses
  std::vector<std::pair<std::string, std::uint64_t>> counters;
  std::uint64_t bytes = 0;  ///< what the last finished frame used
};

}  // namespace tyndall::host
