// One running engine: device, renderer, plugin effect, level. Shared by the command line and the editor; knows neither.
//   session->setLevel(level);
//   render::Graph graph(session->device(), session->graphMemory());
//   auto output = session->buildFrame(graph, request);       // begins a device frame
//   ... add passes: readback, user interface, presentation ...
//   session->submitFrame(graph);                             // compiles, records, submits
// Not thread-safe: one thread owns it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/catalogue.hpp"
#include "app/level.hpp"
#include "base/result.hpp"
#include "gpu/device.hpp"
#include "gpu/pipeline.hpp"
#include "host/host.hpp"
#include "render/frame.hpp"
#include "render/frame_builder.hpp"
#include "render/graph.hpp"

namespace tyndall::app {

struct FrameRequest {
  std::uint32_t width = 1280, height = 720;
  scene::CameraView camera;
  double seconds = 0;                ///< time of the level's animations
  std::string debugView;             ///< "" = the picture
  std::vector<std::string> views{};  ///< debug views to be handed out beside the picture (see ViewReadback)
  bool reset = false;                ///< a cut: what was kept from earlier frames is worthless
  float adaptSeconds = -1;  ///< what automatic exposure has had since the last frame; below 0: it settles at once
  bool meter = false;       ///< measure the picture, also where its exposure is not asked for: Session::metered()
};

class Session {
 public:
  /// Opens the device, the renderer (shaders/ beside the executable) and the effect of the catalogue's plugin.
  static Result<std::unique_ptr<Session>> open(std::unique_ptr<Catalogue> catalogue, const gpu::DeviceOptions& options);
  ~Session();

  /// Uploads the level; the next frame is a cut. On an error no level is set.
  Result<void> setLevel(Level level);
  /// How often a level was set: another number, another level.
  std::uint64_t levelsSet() const { return levelsSet_; }
  /// Lights, where nodes stand, and the numbers of materials may be changed between frames; the next one shows it.
  /// Nothing else of the scene may (meshes, textures, which of them a material has, alpha modes): the rest is uploaded.
  /// A level must be set.
  scene::Scene& editScene() { return level_->scene; }
  const Level* level() const { return level_ ? &*level_ : nullptr; }

  /// Waits for a free frame slot, begins the device's frame and declares the whole deferred frame in `graph`. A level
  /// must be set. After an error the device's frame is closed again.
  Result<render::FrameOutput> buildFrame(render::Graph& graph, const FrameRequest& request);
  /// Compiles, records with a timestamp after each pass, submits. `signals` is for a window's swapchain.
  Result<void> submitFrame(render::Graph& graph, const gpu::FrameSignals& signals = {});
  /// The next frame is as the first after setLevel(): a cut, with the frame number that noise starts from.
  void restart() { frameIndex_ = 0, cut_ = true; }
  /// Waits for every submitted frame and takes its times.
  Result<void> finishFrames();

  /// Times of the newest frame known to be finished, in the order the passes ran; empty before the first.
  const std::vector<render::PassTime>& lastPassTimes() const { return lastTimes_; }
  std::uint64_t finishedFrames() const { return finished_; }  ///< frames whose times were taken

  /// What the newest finished frame that was measured came to: those of automatic exposure, and those asked to.
  const std::optional<render::Metered>& metered() const { return metered_; }
  /// Where a picture's exposure comes from: the picture, the level's hint, or neither.
  enum class ExposureSource { kAutomatic, kLevel, kFixed };
  ExposureSource exposureSource() const;
  /// The linear factor on radiance before the tone map, view.exposure included; of automatic exposure the one of the
  /// newest measured frame.
  float exposureFactor() const;
  /// Automatic exposure is still on its way: another frame with its adaptSeconds brings it on.
  bool exposureMoving() const;

  /// What changed parameters need is built beside the frames (host::PluginEffect, render::FrameBuilder), which go on
  /// with the values before. Off from the start, so that a frame is always of the table's values.
  void buildInBackground(bool on);
  using Background = host::PluginEffect::Background;
  /// kBuilding: something is being built, and frames show what was; kReady: the next frame goes on with it.
  Background background() const;

  /// Debug views of the engine and of the effect's present layout.
  std::vector<render::DebugViewInfo> debugViews() const;

  /// Loads the effect's plugin again from its file; parameter values are kept. On an error the old one stays.
  Result<void> reloadPlugin();
  /// True when the plugin's file was rebuilt since it was loaded.
  bool pluginChanged() const { return catalogue_->effectPlugin().fileChanged(); }
  /// Recompiles changed shaders of engine and plugin; one line per shader changed or broken.
  std::vector<std::string> reloadShaders();

  gpu::Device& device() { return *device_; }
  render::Renderer& renderer() { return *renderer_; }
  render::GraphMemory& graphMemory() { return *memory_; }
  host::PluginEffect& effect() { return *effect_; }
  Catalogue& catalogue() { return *catalogue_; }
  params::Table& table() { return catalogue_->table(); }

  /// The greatest side a picture can have on this device, pixels.
  std::uint32_t maxSide() const;
  const render::GraphStatistics& statistics() const { return statistics_; }            ///< of the last submitted frame
  const std::vector<render::TransientUse>& transients() const { return transients_; }  ///< of the last submitted frame

 private:
  struct Slot {
    gpu::Timestamps timestamps;
    std::vector<render::PassTime> passes;
    bool waiting = false;                  ///< submitted, times not taken yet
    std::optional<std::uint32_t> metered;  ///< of the frame's FrameOutput
  };
  Session() = default;
  void takeTimes(Slot& slot);
  render::FrameSettings asked(const FrameRequest& request) const;
  /// The settings themselves, or in part those before, while what they need is being built.
  render::FrameSettings inEffect(const render::FrameSettings& asked, const render::Renderer::Input& frame);
  Slot& currentSlot() { return slots_[device_->submittedFrames() % slots_.size()]; }

  // Destroyed from the last to the first: the effect before its plugin, everything before the device.
  std::unique_ptr<Catalogue> catalogue_;
  std::unique_ptr<gpu::Device> device_;
  std::unique_ptr<render::GraphMemory> memory_;
  std::unique_ptr<render::Renderer> renderer_;
  std::unique_ptr<render::FrameBuilder> frameBuilder_;
  std::unique_ptr<host::PluginEffect> effect_;
  std::array<Slot, 2> slots_;  ///< as many as the device has frames in flight
  std::optional<Level> level_;
  std::vector<render::PassTime> lastTimes_;
  std::optional<render::Metered> metered_;
  render::GraphStatistics statistics_;
  std::vector<render::TransientUse> transients_;
  std::uint64_t finished_ = 0;
  std::uint64_t frameIndex_ = 0;
  std::uint64_t levelsSet_ = 0;
  std::pair<std::uint32_t, std::uint32_t> lastSize_{0, 0};
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  bool cut_ = true;
  bool inBackground_ = false;
  std::optional<render::FrameSettings> drawn_,
      coming_;                    ///< of frames in the background mode: the last one's, and those being built
  bool momentsForeseen_ = false;  ///< moment maps for the effect alone were built
};

}  // namespace tyndall::app
