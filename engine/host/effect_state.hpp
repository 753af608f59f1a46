// What a PluginEffect keeps between frames.
#pragma once

#include <array>
#include <deque>
#include <optional>
#include <set>

#include "background_builder.hpp"
#include "base/file.hpp"
#include "built.hpp"
#include "plugin_state.hpp"
#include "tuner.hpp"

namespace tyndall::host {

/// A tunable whose parameter is on automatic, in the layout for the structure that was asked for.
struct Automatic {
  std::string key;
  LayoutTunable tunable;
};

struct PluginEffect::State {
  State(gpu::Device& d, Plugin& p, const params::Table& t)
      : device(d),
        plugin(p),
        table(t),
        pipelines(d, p.path().parent_path() / p.id()),
        tuner(TunerStore(cacheFolder().empty() ? std::filesystem::path{} : cacheFolder() / "tunables.json")),
        builder(d) {}
  ~State();

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
  /// A structure as the table asks for it, with its automatic parameters; what is drawn has variants in their place.
  struct Asked {
    Structure structure;
    std::vector<Automatic> automatics;
  };
  /// What is made beside the frames.
  struct Coming {
    std::shared_ptr<Built> built;  ///< without pipelines and resources
    std::vector<std::optional<PipelinePlan>> plans;
    std::vector<BuildStep> steps;
    std::map<std::string, PipelinePtr>
        there;  ///< of its pipelines, those that are made; the layout that is drawn may let go of them meanwhile
    bool made = false;
    std::size_t warmed = 0;  ///< steps whose code this device's driver has
  };

  Result<Layout> ask(TyInstance* instance, const Structure& structure);
  /// A layout for the table's values, a picture and a sun as they might be; nothing is made from it.
  Result<Layout> preview(Structure& structure);
  /// The tunables of a layout whose parameters are on automatic.
  std::vector<Automatic> automaticsOf(const Structure& wanted, const Layout& layout) const;
  /// Puts the variant in use in the place of each automatic value. One tunable is timed at a time.
  Structure resolved(const Structure& wanted, const std::vector<Automatic>& list);

  // effect_update.cpp: at once
  /// All of a Built but pipelines, resources and uniforms.
  Result<std::shared_ptr<Built>> describe(TyInstance* instance, Structure structure, bool castersOffered);
  Result<void> furnish(Built& built);
  Result<void> build(TyInstance* instance, Structure structure, const render::EffectInput& input);
  Result<void> update(const Structure& wanted, const render::EffectInput& input);
  bool bring(const Structure& wanted, const render::EffectInput& input);
  bool prepare(const render::EffectInput& input);

  // effect_background.cpp: beside the frames
  Result<void> updateInBackground(const Structure& wanted, const render::EffectInput& input);
  /// Draws on with the present parameters where picture or lights are others than those it was built for.
  Result<void> keepUp(const Structure& wanted, const render::EffectInput& input);
  Result<void> begin(Structure structure, const render::EffectInput& input);
  Result<void> goOn(const render::EffectInput& input);
  Result<void> swap();
  void forgetComing();
  TyInstance* spare();
  std::vector<Scratch> newScratches(const Layout& layout, std::uint32_t pass, const PipelinePlan& plan,
                                    const std::vector<PassRun>& runs, const render::EffectInput& input) const;
  /// The frame being declared compiles these: nothing is left to do ahead for them.
  void noteCompiled(const Built& built, const std::vector<std::optional<PipelinePlan>>& plans,
                    const render::EffectInput& input);

  /// Lights (TY_NONE: of passes that are not per light) that runs of these passes were recorded for in the frame being
  /// built.
  std::set<std::uint32_t> lightsOf(const std::vector<std::string>& passes) const;

  gpu::Device& device;
  Plugin& plugin;
  const params::Table& table;
  Pipelines pipelines;
  Tuner tuner;

  std::optional<Asked> asked;  ///< what `built` belongs to
  std::shared_ptr<Built> built;
  std::optional<Error> failure;
  Structure refused;                ///< what `failure` belongs to
  std::optional<Error> unprepared;  ///< prepare() returned false for the newest frame
  bool reset = true;                ///< no prepare() has succeeded since the last cut or new layout
  std::uint64_t frame = 0;
  std::deque<Pending> pending;
  std::shared_ptr<const FrameRefs> refs;  ///< of the last addPasses
  std::vector<std::pair<std::string, std::uint64_t>> counters;
  std::uint64_t bytes = 0;                ///< what the last finished frame used
  std::optional<std::uint64_t> moved;     ///< see PluginEffect::bytesMoved()
  std::vector<std::uint64_t> lightBytes;  ///< and each light's own passes of it

  bool background = false;
  TyInstance* second = nullptr;    ///< answers for what is coming while the other prepares frames
  std::optional<Asked> askedNext;  ///< of the table's newest values, when `asked` is not
  std::optional<Coming> coming;
  /// What was drawn before the layout that this frame is the first of, should that have no room.
  std::optional<std::pair<Asked, std::shared_ptr<Built>>> before;
  bool redraw = false;  ///< what is drawn went back after the last frame
  bool open = false;    ///< passes were declared for a frame that is neither submitted nor dropped yet
  /// Of each pipeline: the keys of the scratches that this device's driver has compiled it for, where that happens
  /// late.
  std::map<std::string, std::set<std::string>> compiled;
  BackgroundBuilder builder;
};

}  // namespace tyndall::host
