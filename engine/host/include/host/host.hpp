// Loads plugins and turns their tables into passes of the render graph. dlopen appears in this room only.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "params/params.hpp"
#include "render/frame.hpp"

namespace tyndall::host {

struct TechniqueInfo {
  std::string id, name, doc;
  std::vector<std::string> reads;
};
struct PluginDebugView {
  std::string name, doc;
  render::ViewRole role = render::ViewRole::kPlain;
};

/// A loaded plugin: library, tables (copied), instance.
class Plugin {
 public:
  /// Loads a uniquely named copy of `library` (so that a rebuilt one can be loaded beside it), checks the ABI version
  /// before anything else, calls init and create. Errors: missing file, not a shared library, no entry symbol, another
  /// ABI version (both are named), a duplicate or malformed parameter table, init or create failed.
  static Result<std::unique_ptr<Plugin>> load(const std::filesystem::path& library);
  ~Plugin();  ///< destroy, shutdown, unload, remove the copy

  const std::string& id() const;
  const std::string& name() const;
  const std::string& version() const;
  const std::string& doc() const;
  const std::filesystem::path& path() const;  ///< the original, not the copy
  const std::vector<params::Parameter>& parameters() const;
  const std::vector<TechniqueInfo>& techniques() const;
  std::uint32_t selector() const;  ///< index of the parameter that chooses the technique, or TY_NONE (0xffffffff)
  bool fileChanged() const;        ///< the original was rebuilt since it was loaded

  struct State;
  State& state() { return *state_; }

 private:
  Plugin() = default;
  std::unique_ptr<State> state_;
};

/// Every <folder>/*.so in name order. A plugin that cannot be loaded is one Error; the others are loaded all the same.
struct PluginSet {
  std::vector<std::unique_ptr<Plugin>> plugins;
  std::vector<Error> errors;
};
PluginSet loadPlugins(const std::filesystem::path& folder);

/// Runs one plugin as an Effect of the renderer: keeps layout, pipelines and history images, remakes them when the
/// structure changes, fills uniforms, adds the passes.
class PluginEffect : public render::Effect {
 public:
  /// `table` holds the plugin's parameters (added by the caller); values are read from it each frame.
  static Result<std::unique_ptr<PluginEffect>> create(gpu::Device& device, Plugin& plugin, const params::Table& table);
  ~PluginEffect() override;

  /// Empty when the plugin has nothing to do, cannot prepare this frame, or failed (see failure()).
  Result<render::ImageRef> addPasses(const render::EffectInput& input) override;
  /// Of the last addPasses. Where lights take turns in an image, it shows the last light's.
  DebugImage debugImage(const std::string& name) override;

  /// Debug views of the current layout (after the first addPasses), or of a layout made for `values` without running.
  std::vector<PluginDebugView> debugViews() const;
  /// Counters of the last finished frame by name (TyCounters), e.g. skipped work by reason.
  std::vector<std::pair<std::string, std::uint64_t>> counters() const;
  /// What a tunable parameter resolved to ("volumetrics.prefix_scheme", "row"), measured or asked for.
  std::vector<std::pair<std::string, std::string>> resolved() const;
  /// The same for every parameter on automatic, as measured in this program or an earlier one: of the current layout
  /// or, before the first addPasses, of one made for the present values without running (1280x720, one sun). An empty
  /// value: not measured yet.
  std::vector<std::pair<std::string, std::string>> remembered() const;
  /// Call once per finished frame with its pass times: feeds the tuner of speed-only variants.
  void frameFinished(const std::vector<render::PassTime>& passes);
  std::vector<std::string> reloadShaders();

  /// On: where a changed parameter needs a new layout, frames go on with the old one until the new one's pipelines and
  /// images are there, made on another thread; the newest change wins, and what cannot be made leaves the old one (see
  /// failure()). Only a change of the picture's size or of the lights is followed at once. Off, as from the start:
  /// every change is.
  void buildInBackground(bool on);
  enum class Background {
    kIdle,
    kBuilding,  ///< a frame declared now would be the same as the last
    kReady,     ///< the next frame goes on with what was built
  };
  Background background() const;
  /// Whether the layout, or the one that is being built, reads moment shadow maps.
  bool readsShadowMoments() const;
  /// Call one of these after addPasses(): the frame was submitted, or it was not, because of `reason`. If it was the
  /// first of a layout made in the background, the one before comes back.
  void frameSubmitted();
  void frameDropped(const Error& reason);
  /// What the passes of the last finished frame used: images, buffers, the output, each on its own. Those of passes
  /// that the graph dropped (debug views that are not shown) do not count, history always does.
  std::uint64_t memoryBytes() const;
  /// Bytes that the passes of the last finished frame moved if each read and wrote every part of the plugin's own
  /// images and buffers, and of the output, that it was bound to once: over a device's bandwidth, about the least time
  /// that they can take. Nothing where several lights have passes: they take turns in images of which each uses a part.
  std::optional<std::uint64_t> bytesMoved() const;
  /// What the passes of each light, most important first, touched in the last finished frame, the output aside. Lights
  /// take turns in the same memory, so that these do not add up to memoryBytes(); 0: the light reached no view ray, or
  /// has no passes of its own.
  std::vector<std::uint64_t> lightMemoryBytes() const;
  /// Why the plugin is off or, when built in the background, still has the layout of earlier settings: a layout was
  /// refused or could not be made (also logged, once). A changed setting or shader starts anew. Or that the newest
  /// frame was drawn without it, since its prepare() returned false (logged once, until it succeeds).
  const std::optional<Error>& failure() const;

  struct State;

 private:
  PluginEffect() = default;
  std::unique_ptr<State> state_;
};

}  // namespace tyndall::host
