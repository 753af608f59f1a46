// The deferred frame: G-buffer, shadow maps, lighting, sky, transparent surfaces, volumetrics (through an Effect),
// tone map.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "base/result.hpp"
#include "gpu/device.hpp"
#include "render/graph.hpp"
#include "scene/scene.hpp"

namespace tyndall::render {

/// The camera as matrices. Reversed depth: 1 at znear, 0 at zfar.
struct View {
  std::uint32_t width = 0, height = 0;
  glm::mat4 viewFromWorld{1}, worldFromView{1}, clipFromView{1}, viewFromClip{1};
  glm::vec3 eye{0};
  float znear = 0.1f, zfar = 1000.0f;
  double seconds = 0;
  std::uint64_t frameIndex = 0;
};
/// `level` is the box of everything in the level, of which only cameras without a far plane need to know.
View makeView(const scene::CameraView& camera, std::uint32_t width, std::uint32_t height,
              const scene::Bounds& level = {});

/// A light with its shadow map, as effects see it. Depth stored: 0 nearest the light, 1 where nothing was drawn.
struct ShadowedLight {
  scene::LightView light;
  ImageRef shadowMap;  ///< D32 array image of this light's own: 1 layer, 6 for a point light
  /// Four-moment shadow map of the same size, with all mips: RGBA16 unorm (quantised) or RGBA32F. Passes that make it
  /// run only if something reads it. Empty where the device cannot filter the format.
  ImageRef moments;
  std::uint32_t faceCount = 1;
  std::uint32_t size = 0;                    ///< texels a side
  std::array<glm::mat4, 6> clipFromWorld{};  ///< of each face
  std::array<glm::vec3, 8> casterCorners{};  ///< corners of the box of all casters, world space
  /// The image that the light shines through: layers [cookieLayer, cookieLayer + cookieFaces) of an array that all
  /// lights share, linear colours with all mips; a white texel (layer 0) for a light without. Empty: nothing of this is
  /// offered.
  ImageRef cookie;
  std::uint32_t cookieLayer = 0;
  std::uint32_t cookieFaces = 0;    ///< 0: none; 1, or the 6 of a point light
  std::uint32_t cookieRepeats = 0;  ///< bit 0 along x, bit 1 along y; else the image's border goes on
  glm::mat4 cookieFromWorld{1};     ///< TyLight.cookie_from_world
};

/// What the numbers of a debug view mean: TyViewRole of the plugins' ABI.
enum class ViewRole {
  kPlain,
  kRows,
  kRowDepths,
  kRowPlace,
  kLightRayStart,
  kLightRayEnd,
  kReference,
  kWalkRanks,
  kWalkLevel,
  kWalkLevelAcross
};

/// What an effect (the plugin host) is given while the graph is built.
struct EffectInput {
  Graph& graph;
  const View& view;
  ImageRef depth;                            ///< D32, reversed
  const std::vector<ShadowedLight>& lights;  ///< only lights that have shadow maps
  bool reset = false;                        ///< a cut: history is worthless
  /// Draws all shadow casters (alpha-tested where needed) inside a caster pass's rendering: every vertex is
  /// transformed by
  /// `clipFromWorld` alone; depth clamp on, both faces. The rendering has one D32 target and no colour; depth is tested
  /// LESS_OR_EQUAL and written. Null when not offered.
  std::function<void(PassContext&, const glm::mat4& clipFromWorld)> drawCasters;
};

/// Something that computes in-scattered radiance and transmittance between eye and surface.
class Effect {
 public:
  virtual ~Effect() = default;
  /// Adds passes and returns an RGBA32F image (RGB scatter, A transmittance) of the view's size, or an empty ref when
  /// there
  /// is nothing to do (scatter 0, transmittance 1).
  virtual Result<ImageRef> addPasses(const EffectInput& input) = 0;
  /// An image to show instead of the picture for this debug view, or empty if the view is not the effect's.
  struct DebugImage {
    ImageRef image;
    gpu::ViewDesc view{};
    std::uint32_t channel = 4;
    float low = 0, high = 1;
  };
  virtual DebugImage debugImage(const std::string& name) = 0;
};

/// How shadow maps are filtered when surfaces are lit.
enum class ShadowMode { kPcf, kMoments };

struct FrameSettings {
  float exposure = 1;         ///< linear factor before the tone map
  bool autoExposure = false;  ///< times a factor that suits the picture, which is measured in the frame itself
  bool meter = false;         ///< measure the picture, also where its exposure is not asked for (FrameOutput::metered)
  /// How long the measured factor has had since the last frame; below 0: it settles at once.
  float adaptSeconds = -1;
  float shownExposure = 1;  ///< factor of debug views that show radiance "times exposure"
  std::uint32_t shadowResolution = 2048;
  bool reuseShadows =
      false;              ///< maps outlive the frame and are drawn again only when their light or a caster has changed
  float skyStrength = 1;  ///< factor on the sky's light on surfaces
  ShadowMode shadowMode = ShadowMode::kPcf;
  std::uint32_t shadowPrecision = 64;  ///< bits per texel of moment shadow maps: 64 or 128
  std::string debugView;               ///< "" = the picture; engine views: see debugViews()
  std::vector<std::string>
      offered;  ///< debug views whose images are handed out beside the picture (FrameOutput::views)
};

/// What a frame's picture was measured to be, while its scatter and depth were at hand.
struct Metered {
  float factor = 1;         ///< that automatic exposure uses
  float target = 1;         ///< that this picture asks for
  float surfaces = 0;       ///< part of the pixels that shows a surface
  float transmittance = 1;  ///< of the air in front of these, their mean
  float distance = 0;       ///< of these along the rays, their median, metres
};

struct FrameOutput {
  View view;                             ///< what the frame was drawn with
  ImageRef picture;                      ///< RGBA8 unorm, sRGB-coded
  ImageRef scatter;                      ///< RGBA32F, empty when the effect had nothing to do
  ImageRef depth;                        ///< D32, reversed
  ImageRef color;                        ///< RGBA32F radiance of surfaces and sky, before medium, exposure and tone map
  std::optional<std::uint32_t> metered;  ///< for Renderer::metered(), once the frame is done
  /// Of FrameSettings::offered, in its order; no image where this frame has none. Passes that only they need run if a
  /// later pass reads them.
  std::vector<Effect::DebugImage> views;
};

/// Name and help of each of the engine's own debug views ("depth", "normal", "base_color", "shadow_map", ...).
struct DebugViewInfo {
  std::string name, doc;
  ViewRole role = ViewRole::kPlain;
};

class PipelineLibrary;

class Renderer {
 public:
  /// `shaderFolder` holds the engine's .spv files.
  static Result<std::unique_ptr<Renderer>> create(gpu::Device& device, const std::filesystem::path& shaderFolder);
  ~Renderer();

  /// Uploads a level (replacing the last one). Errors: lack of memory, an image larger than the device takes.
  Result<void> setScene(const scene::Scene& scene);

  struct Input {
    const scene::Scene& scene;  ///< the one given to setScene
    std::vector<glm::mat4> worldFromNode;
    scene::CameraView camera;
    std::vector<scene::LightView> lights;
    std::uint32_t width = 1280, height = 720;
    double seconds = 0;
    std::uint64_t frameIndex = 0;
    bool reset = false;
    FrameSettings settings;
    Effect* effect = nullptr;
  };
  /// Declares the whole frame in `graph`. The caller adds readback or presentation passes, compiles and records.
  Result<FrameOutput> addFrame(Graph& graph, const Input& input);

  /// Adds a pass that writes the distance along each pixel's ray (metres, R32F) from the depth.
  ImageRef addDistance(Graph& graph, const View& view, ImageRef depth);

  /// What was measured by the frame whose FrameOutput::metered this is. The frame is done, and none of the three after
  /// it has been declared.
  Metered metered(std::uint32_t slot) const;

  /// Recompiles changed shaders; a broken one keeps its last good pipeline. Returns one line per shader changed or
  /// broken.
  std::vector<std::string> reloadShaders();

  static std::vector<DebugViewInfo> debugViews();
  /// What the last frame left out, one line each: lights that got no shadow map, with the reason; what a map cannot
  /// cover.
  const std::vector<std::string>& notes() const;

  struct State;

 private:
  friend class FrameBuilder;
  Renderer() = default;
  PipelineLibrary& pipelines();
  std::unique_ptr<State> state_;
};

}  // namespace tyndall::render
