// Puts the frame together: blocks, passes in order, effect, output.
#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "debug_views.hpp"
#include "draw_record.hpp"
#include "exposure.hpp"
#include "passes.hpp"
#include "render/frame.hpp"
#include "sky.hpp"
#include "sky_maps.hpp"
#include "textures.hpp"

namespace tyndall::render {

struct Renderer::State {
  State(gpu::Device& d, const std::filesystem::path& shaders)
      : device(d), pipelines(d, shaders), blocks(d), shadows(d), skyMaps(d), samplers(makeSamplers(d)) {}

  PassTools tools() {
    gpu::ViewDesc array;
    array.array = true;
    return {pipelines, samplers, unusedMap.view(array)};
  }
  Result<std::shared_ptr<FrameData>> prepare(const Input& input);

  gpu::Device& device;
  PipelineLibrary pipelines;
  BlockRing blocks;
  ShadowCache shadows;
  SkyMaps skyMaps;
  FrameSamplers samplers;
  gpu::Image unusedMap;
  ExposureMeter exposure;
  std::shared_ptr<const SceneResources> resources;
  std::vector<std::string> notes;
};

Renderer::~Renderer() = default;

Result<std::unique_ptr<Renderer>> Renderer::create(gpu::Device& device, const std::filesystem::path& shaderFolder) {
  std::unique_ptr<Renderer> renderer(new Renderer);
  renderer->state_ = std::make_unique<State>(device, shaderFolder);
  Result<gpu::Image> white = uploadTexture(device, {"unused shadow map", 1, 1, {255, 255, 255, 255}}, false);
  if (!white) return white.error();
  renderer->state_->unusedMap = white.take();
  Result<ExposureMeter> meter = ExposureMeter::create(device);
  if (!meter) return meter.error();
  renderer->state_->exposure = meter.take();
  // A missing shader folder is told at once, not at the first frame.
  Result<const gpu::Pipeline*> probe = renderer->state_->pipelines.get(compositeRecipe(false, false));
  if (!probe) return probe.error();
  return renderer;
}

Result<void> Renderer::setScene(const scene::Scene& scene) {
  Result<std::shared_ptr<const SceneResources>> uploaded = uploadScene(state_->device, scene);
  if (!uploaded) return uploaded.error();
  state_->resources = uploaded.take();
  state_->shadows.clear();
  state_->skyMaps.clear();
  state_->pipelines.sceneChanged();
  return {};
}

namespace {

shared::ViewBlock makeViewBlock(const View& view, const glm::mat4& clipFromWorld,
                                const std::vector<scene::LightView>& lights) {
  shared::ViewBlock block{};
  block.viewFromWorld = view.viewFromWorld;
  block.worldFromView = view.worldFromView;
  block.clipFromView = view.clipFromView;
  block.viewFromClip = view.viewFromClip;
  block.clipFromWorld = clipFromWorld;
  block.eye = view.eye;
  block.znear = view.znear;
  block.zfar = view.zfar;
  block.size = {view.width, view.height};
  block.seconds = static_cast<float>(view.seconds);
  fillSky(block, lights);
  return block;
}

// Undefined where the device cannot filter it: linear filtering of 32-bit floats is optional in Vulkan.
VkFormat momentFormat(const gpu::Device& device, std::uint32_t precision) {
  TY_ASSERT(precision == 64 || precision == 128, std::to_string(precision) + " bits of moments; there are 64 and 128");
  const VkFormat format = precision == 64 ? kMoments64Format : kMoments128Format;
  VkFormatProperties properties{};
  vkGetPhysicalDeviceFormatProperties(device.physical(), format, &properties);
  const VkFormatFeatureFlags needed =
      VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT | VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;
  return (properties.optimalTilingFeatures & needed) == needed ? format : VK_FORMAT_UNDEFINED;
}

// Depths, and the moments that surfaces read: mips add a third. Moments that only an effect reads are not known of yet,
// because it is asked after the lights are planned.
double shadowTexelBytes(const FrameData& frame) {
  if (frame.surfaceMaps == ShadowMaps::kDepths) return kDepthTexelBytes;
  return kDepthTexelBytes + gpu::texelBytes(frame.momentFormat) * 4.0 / 3;
}

}  // namespace

Result<std::shared_ptr<FrameData>> Renderer::State::prepare(const Input& input) {
  auto frame = std::make_shared<FrameData>();
  frame->view =
      makeView(input.camera, input.width, input.height,
               input.camera.camera.zfar ? scene::Bounds{} : scene::worldBounds(input.scene, input.worldFromNode));
  frame->view.seconds = input.seconds;
  frame->view.frameIndex = input.frameIndex;
  frame->clipFromWorld = glm::mat4(glm::dmat4(frame->view.clipFromView) * glm::dmat4(frame->view.viewFromWorld));
  frame->resources = resources;
  frame->draws = buildDrawList(input.scene, *resources, input.worldFromNode, frame->view.eye);
  frame->momentFormat = momentFormat(device, input.settings.shadowPrecision);
  if (input.settings.shadowMode == ShadowMode::kMoments) {
    if (frame->momentFormat == VK_FORMAT_UNDEFINED)
      return badCall("shadows.precision: " + std::to_string(input.settings.shadowPrecision) +
                     "; this device cannot filter such maps, shadows.mode=moments takes the other precision");
    frame->surfaceMaps = frame->momentFormat == kMoments64Format ? ShadowMaps::kQuantisedMoments : ShadowMaps::kMoments;
  }
  frame->plan = planLights(frame->view, input.lights, frame->draws.casters, input.settings.shadowResolution,
                           kShadowBudgetBytes, shadowTexelBytes(*frame));
  for (std::size_t i = 0; i < frame->plan.blocks.size(); ++i) {
    const std::size_t shadowed = frame->plan.shadowed.size();
    const std::uint32_t source = i < shadowed ? frame->plan.shadowed[i].source : frame->plan.unshadowed[i - shadowed];
    frame->plan.blocks[i].cookie = cookieBlock(input.lights[source], resources->cookies);
    frame->cookies |= frame->plan.blocks[i].cookie.faces != 0;
  }

  const shared::ViewBlock view = makeViewBlock(frame->view, frame->clipFromWorld, input.lights);
  // Whole groups of slots, because the block of a group is bound as one.
  std::vector<shared::LightBlock> lightBlocks = frame->plan.blocks;
  lightBlocks.resize((lightBlocks.size() / kShadowSlots + 1) * kShadowSlots);
  const auto& instances = frame->draws.instances;
  TY_ASSERT(
      input.scene.materials.size() + 1 == resources->materials.size(),
      "the scene is not the one given to setScene: " + std::to_string(input.scene.materials.size()) + " materials");
  const std::vector<std::byte> materials = materialBlocks(input.scene);
  frame->materialsHash = Hash().bytes(materials).value();
  const FrameSettings& settings = input.settings;
  Result<std::shared_ptr<const SkyFrame>> sky = skyMaps.plan(*frame, settings.skyStrength);
  if (!sky) return sky.error();
  frame->sky = sky.take();
  Result<std::vector<BlockRange>> ranges =
      blocks.write({{&view, sizeof(view)},
                    {lightBlocks.data(), lightBlocks.size() * sizeof(lightBlocks[0])},
                    {instances.data(), instances.size() * sizeof(instances[0])},
                    {materials.data(), materials.size()},
                    {&frame->sky->block, sizeof(frame->sky->block)}});
  if (!ranges) return ranges.error();
  frame->viewBlock = (*ranges)[0];
  frame->lightBlocks = (*ranges)[1];
  frame->instanceBlocks = (*ranges)[2];
  frame->materialBlocks = (*ranges)[3];
  frame->skyBlock = (*ranges)[4];
  return frame;
}

Result<FrameOutput> Renderer::addFrame(Graph& graph, const Input& input) {
  TY_ASSERT(state_->resources, "addFrame before setScene");
  state_->pipelines.beginFrame();
  const VkPhysicalDeviceLimits& limits = state_->device.info().limits;
  const std::uint32_t largest = limits.maxImageDimension2D;
  if (input.width == 0 || input.height == 0 || input.width > largest || input.height > largest) {
    return badCall("picture: size " + std::to_string(input.width) + "x" + std::to_string(input.height) +
                   "; each side must be 1 to " + std::to_string(largest) + " on this device");
  }
  const std::uint32_t shadowSize = input.settings.shadowResolution;
  if (shadowSize == 0 || shadowSize > largest) {
    return badCall("shadows.resolution: " + std::to_string(shadowSize) + "; must be 1 to " + std::to_string(largest) +
                   " on this device");
  }

  Result<std::shared_ptr<FrameData>> prepared = state_->prepare(input);
  if (!prepared) return prepared.error();
  const std::shared_ptr<FrameData>& frame = *prepared;
  const PassTools tools = state_->tools();
  const std::string& debugView = input.settings.debugView;
  if (input.effect) {
    constexpr VkImageLayout kRead = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    frame->noCookie = graph.import(state_->unusedMap, kRead, kRead);
    if (frame->cookies) frame->cookieArray = graph.import(frame->resources->cookies.image, kRead, kRead);
  }
  if (!input.settings.reuseShadows) state_->shadows.clear();
  if (Result<void> r =
          addShadowPasses(graph, tools, frame, input.lights, input.settings.reuseShadows ? &state_->shadows : nullptr);
      !r)
    return r.error();
  if (Result<void> r = addSkyPasses(graph, tools, frame); !r) return r.error();
  if (Result<void> r = addGBufferPass(graph, tools, frame, !debugView.empty() || !input.settings.offered.empty()); !r)
    return r.error();
  if (Result<void> r = addLightingPasses(graph, tools, frame, input.lights); !r) return r.error();
  if (Result<void> r = addTransparentPass(graph, tools, frame); !r) return r.error();

  FrameOutput output;
  output.view = frame->view;
  output.depth = frame->depth;
  output.color = frame->color;
  if (input.effect) {
    const Result<CasterPipelines> casters = casterPipelines(state_->pipelines);
    if (!casters) return casters.error();
    const auto draw = [frame = FramePointer(frame), casters = *casters](PassContext& context,
                                                                        const glm::mat4& clipFromWorld) {
      recordCasters(context, *frame, casters, clipFromWorld);
    };
    Result<ImageRef> scatter =
        input.effect->addPasses({graph, frame->view, frame->depth, frame->shadowedLights, input.reset, draw});
    if (!scatter) return scatter.error();
    output.scatter = *scatter;
  }

  const FrameSettings& settings = input.settings;
  if (settings.autoExposure || settings.meter) {
    const Result<std::uint32_t> slot = state_->exposure.addPass(graph, tools, frame->view, frame->color, output.scatter,
                                                                frame->depth, settings.adaptSeconds);
    if (!slot) return slot.error();
    output.metered = *slot;
  }
  const auto composite = [&] {
    return addCompositePass(graph, tools, frame->color, output.scatter, settings.exposure, state_->exposure.metered(),
                            settings.autoExposure);
  };
  if (debugView.empty()) {
    Result<ImageRef> picture = composite();
    if (!picture) return picture.error();
    output.picture = *picture;
  } else {
    Result<Effect::DebugImage> shown = Effect::DebugImage{};
    if (isEngineDebugView(debugView)) {
      shown = engineDebugImage(graph, tools, *frame, debugView, output.scatter, settings.shownExposure);
      if (!shown) return shown.error();
    } else {
      TY_ASSERT(input.effect, "debug view '" + debugView + "' is not the engine's and there is no effect");
      shown = input.effect->debugImage(debugView);
    }
    // A view of the layout before, or one that this frame's lights leave empty: not a mistake of the caller's.
    const bool none = !isEngineDebugView(debugView) && !shown->image;
    if (none)
      frame->plan.notes.push_back("debug view '" + debugView + "': there is none in this frame; the picture is shown");
    Result<ImageRef> picture = none ? composite() : addDebugPass(graph, tools, frame->view, *shown);
    if (!picture) return picture.error();
    output.picture = *picture;
  }
  for (const std::string& name : input.settings.offered) {
    Result<Effect::DebugImage> view = Effect::DebugImage{};
    if (isEngineDebugView(name))
      view = engineDebugImage(graph, tools, *frame, name, output.scatter, settings.shownExposure);
    else if (input.effect)
      view = input.effect->debugImage(name);
    if (!view) return view.error();
    output.views.push_back(*view);
  }
  state_->notes = frame->plan.notes;
  if (std::string far = scene::roundingNote(input.camera); !far.empty()) state_->notes.push_back(std::move(far));
  return output;
}

ImageRef Renderer::addDistance(Graph& graph, const View& view, ImageRef depth) {
  Result<ImageRef> distance = addDistancePass(graph, state_->tools(), view, depth);
  TY_ASSERT(distance.ok(), distance.error().message);
  return *distance;
}

Metered Renderer::metered(std::uint32_t slot) const {
  const shared::MeteredBlock block = state_->exposure.read(slot);
  const float samples = static_cast<float>(std::max(block.samples, 1u));
  return {std::exp2(block.logFactor), std::exp2(block.logTarget), static_cast<float>(block.surfaces) / samples,
          block.transmittance, block.distance};
}

PipelineLibrary& Renderer::pipelines() { return state_->pipelines; }
std::vector<std::string> Renderer::reloadShaders() { return state_->pipelines.reload(); }
const std::vector<std::string>& Renderer::notes() const { return state_->notes; }

}  // namespace tyndall::render
