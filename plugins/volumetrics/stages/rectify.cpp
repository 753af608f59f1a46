#include "stages/rectify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "geometry/camera_rays.hpp"
#include "geometry/linear_frame.hpp"
#include "stages/local_lights.hpp"
#include "stages/suns.hpp"

namespace volumetrics {
namespace {

/// Segments are whole multiples of this, so that three mip levels never mix two of them.
constexpr std::uint32_t kSegmentAlignment = 8;
/// Maps of further lights are whole multiples of this, and at least so large.
constexpr std::uint32_t kMapStep = 64;

/// Side of the table of unshadowed integrals (rays_on_rows.glsl): bilinear in it, they are within 10^-4 of the mean.
constexpr std::uint32_t kUnshadowedSize = 256;
/// A lamp this near to the eye, m, is left to a march, and one beyond kFarFromEye to the rows; between, one fades into
/// the other. Nearer than a cone is wide, the rays of one slice go through quite different parts of it, which the few
/// reference rays of a slice cannot tell (nRMSE of 0.1 to 0.16 from 1 mm to 1.5 m), and at the eye itself there is no
/// axis for slices to turn about. A march by angles at the lamp needs few strata then: most of the light comes from
/// where nothing stands.
constexpr float kNearEye = 1.2f, kFarFromEye = 1.8f;

Rectification rectification(const Settings& settings) { return static_cast<Rectification>(settings.rectification); }
/// Whether the maps of a class may be projective: those of suns without cookies, unless the rectification is epipolar
/// alone.
bool isProjective(const Settings& settings, const LightClass& lights) {
  return !lights.local && !lights.coloured && rectification(settings) != Rectification::kEpipolar;
}

/// Parts that are prefixed each on its own: `regions` of each map.
void setSegments(RectificationBlock& map, std::uint32_t regions) {
  map.segmentCount = 0;
  map.segmentStart[0] = 0;
  const std::uint32_t even = (map.columns + regions - 1) / regions;
  const std::uint32_t length = (even + kSegmentAlignment - 1) / kSegmentAlignment * kSegmentAlignment;
  for (std::uint32_t split = 0; split < map.splits; ++split)
    for (std::uint32_t start = 0; start < map.columns; start += length)
      map.segmentStart[++map.segmentCount] = split * map.columns + std::min(start + length, map.columns);
}

/// One part: the columns of all maps.
void setWhole(RectificationBlock& map) {
  map.segmentCount = 1;
  map.segmentStart[0] = 0;
  map.segmentStart[1] = map.columns * map.splits;
}

/// An epipolar map that stands in for projective ones is parted where they would be, so that a switch between both
/// changes neither the number of look-ups nor what joining them brings. `projective`: the projective map, if there is
/// one for this view.
void setSegmentsByDistance(RectificationBlock& map, std::uint32_t splits, std::uint32_t regions, float znear,
                           const std::optional<LinearFrame>& projective) {
  std::array<double, kMaxSplits + 1> along{};
  if (projective && projective->block.polygonCount > 0) {
    for (std::uint32_t i = 0; i <= splits; ++i) along[i] = 1.0 / projective->block.inverse[i];
  } else {
    // With the light near the screen the projective maps begin at about a quarter of the near plane's distance.
    along = splitBorders(std::min(0.25 * znear, 0.5 * map.reach), map.reach, splits, map.columns / splits);
  }
  map.segmentsByDistance = 1;
  map.segmentCount = splits * regions;
  for (std::uint32_t split = 0; split < splits; ++split)
    for (std::uint32_t region = 0; region < regions; ++region) {
      // Columns of a projective map, and so its regions, are even in 1/x.
      const double share = static_cast<double>(region) / regions;
      map.segmentDistance[split * regions + region] =
          static_cast<float>(1 / ((1 - share) / along[split] + share / along[split + 1]));
    }
}

/// Where a direction meets the screen, pixels; far off the screen if it never does.
glm::vec2 onScreen(const RayBlock& rays, const glm::vec3& direction) {
  const float along = glm::dot(direction, rays.forward);
  if (along < 1e-6f) return glm::vec2(-1e9f);
  const glm::vec2 ndc(glm::dot(direction, rays.right) / (glm::dot(rays.right, rays.right) * along),
                      -glm::dot(direction, rays.up) / (glm::dot(rays.up, rays.up) * along));
  return (ndc + 1.0f) / rays.pixelScale;
}

/// The map of a sun, parted, made by `passes`: their matrices are filled, and those that it does not need left out.
RectificationBlock makeMap(const FrameContext& context, const Settings& settings, const RectificationInput& input,
                           const MapPasses& passes, std::uint32_t light, const std::optional<LinearFrame>& linear,
                           bool useLinear, bool parted) {
  const bool mayBeLinear = rectification(settings) != Rectification::kEpipolar && !input.wholeView;
  RectificationInput wide = input;
  if (!input.wholeView) wide.columns *= std::max(1u, passes.splits);
  RectificationBlock map = useLinear ? linear->block : epipolarBlock(wide);
  const auto regions = static_cast<std::uint32_t>(settings.regions);
  if (!parted)
    setWhole(map);
  else if (!useLinear && mayBeLinear && passes.splits > 1 && map.reach > 0)
    setSegmentsByDistance(map, passes.splits, regions, input.rays.znear, linear);
  else
    setSegments(map, regions);
  map.depthPower = 1.0f / (1.0f + settings.depth_warp);
  if (useLinear) context.skip(passes.rectifyPass, light);
  for (std::uint32_t i = 0; i < passes.splits; ++i) {
    context.block<glm::mat4>(passes.casterBlock + i, light) = useLinear ? linear->clipFromWorld[i] : glm::mat4(0.0f);
    if (!useLinear || map.polygonCount == 0) context.skip(passes.casterPass + i, light);
  }
  return map;
}

/// Chooses the rectification of a sun in this frame, or shares its light between two. Returns whether the second map,
/// `fading`, has a part; what is not about maps is left to the caller there.
bool chooseMaps(const FrameContext& context, const Settings& settings, const RectificationInput& input,
                std::uint32_t light, bool parted, RectifiedLightBlock& block, RectifiedLightBlock* fading) {
  std::optional<LinearFrame> linear;
  const bool mayBeLinear = rectification(settings) != Rectification::kEpipolar && !input.wholeView;
  const bool mustBeLinear = rectification(settings) == Rectification::kLinear;
  context.report.linearCookie |= mustBeLinear && input.wholeView;
  if (mayBeLinear) linear = linearFrame(input, context.roles.map.splits);
  context.report.linearImpossible |= mayBeLinear && !linear && mustBeLinear;

  const double share = !linear ? 0.0 : mustBeLinear ? linearHold(*linear) : linearShare(*linear);
  context.report.linearHandsOver |= mustBeLinear && linear && share < 1;
  const bool useLinear = share >= 0.5, both = fading != nullptr && share > 0 && share < 1;
  block.map = makeMap(context, settings, input, context.roles.map, light, linear, useLinear, parted);
  block.map.share = 1;
  if (!both) return false;
  block.map.share = static_cast<float>(useLinear ? share : 1 - share);
  fading->map = makeMap(context, settings, input, context.roles.fadingMap, light, linear, !useLinear, parted);
  fading->map.share = 1 - block.map.share;
  return true;
}

/// The most important light has the map that the settings ask for; further ones have as much as they have of the
/// screen.
void shareOfScreen(const FrameContext& context, RectificationInput& input, std::uint32_t light,
                   const LocalBlock& local) {
  if (light == 0) return;
  const double side = std::sqrt(screenShare(local, context.block<RectifiedBlock>(kFrameBlock).rays));
  const auto part = [&](std::uint32_t whole) {
    const auto wanted = static_cast<std::uint32_t>(std::ceil(side * whole / kMapStep)) * kMapStep;
    return std::clamp(wanted, std::min(kMapStep, whole), whole);
  };
  input.columns = part(input.columns);
  input.slices = part(input.slices);
}

/// What reference rays leave to columns that they do not see themselves, since their psi ends at pi - theta or the
/// light's range ends before: the weight that the farthest blocker has for those who see it. Found on views of two
/// levels with lamps, and of one whose range ends in the air: leaving nothing has errors of 0.15 beside the antipode of
/// a lamp, leaving the same to all of 0.11 where a range ends.
void setLeastWeights(const TyLight& light, const glm::vec3& eye, float sigma_t, RectifiedLightBlock& block) {
  constexpr float kMostWay = 4, kLeastWindow = 0.02f, kPartOfBox = 0.75f;
  float fromLight = 0, fromEye = 0;
  for (const auto& corner : light.caster_corners) {
    fromLight = std::max(fromLight, glm::distance(glm::make_vec3(corner), glm::make_vec3(light.position)));
    fromEye = std::max(fromEye, glm::distance(glm::make_vec3(corner), eye));
  }
  // Corners of a box are farther off than what most rays end on.
  fromLight *= kPartOfBox;
  fromEye *= kPartOfBox;
  block.mostWay = std::min(sigma_t * (fromLight + fromEye), kMostWay);
  const float q = block.local.range > 0 ? fromLight / block.local.range : 0.0f;
  block.leastWindow = std::max(1 - q * q * q * q, kLeastWindow);
}

/// Passes "shine" and "lit".
void addShine(LayoutBuilder& builder, RectifyStage& stage, std::uint32_t rays, const Settings& settings) {
  const std::uint32_t channels = rays * (stage.lights.coloured ? 3 : 1), quads = (channels + 3) / 4;
  stage.weights = builder.image("column_weights", TY_FORMAT_RGBA32_FLOAT, stage.slices, stage.rows, quads, true);
  stage.lit = builder.image("lit", TY_FORMAT_RGBA16_UNORM, stage.slices, stage.rows, quads, true);
  const TyBinding slices = bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_READ);
  builder.compute({"shine",
                   "shine.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), slices,
                    lightCookieAt(3, stage.lights.coloured), storageAt(4, stage.weights)},
                   groups8(stage.slices),
                   groups8(stage.rows),
                   1,
                   kEachLight,
                   {{1, rays}}});
  const std::uint32_t parts =
      stage.rows / static_cast<std::uint32_t>(settings.columns) * static_cast<std::uint32_t>(settings.regions);
  builder.compute({"lit",
                   "lit.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), slices, sampledAt(3, stage.weights),
                    storageAt(4, stage.lit)},
                   groups8(stage.slices),
                   parts,
                   1,
                   kEachLight,
                   {{1, rays}}});
  builder.debugView(
      "lit", "What fully lit rays receive of the light's strength and colour up to each column, first reference ray",
      TY_SOURCE_IMAGE, stage.lit, 0, stage.lights.coloured ? 4 : 0, 0.0f, 1.0f, TY_VIEW_ROWS);
}

}  // namespace

void addRowBlocks(const LayoutContext& context, LayoutBuilder& builder) {
  builder.uniform("frame", sizeof(RectifiedBlock), false);
  builder.uniform("light", sizeof(RectifiedLightBlock), true);
  builder.uniform("local light", sizeof(LocalBlock), true);
  builder.uniform("cookie", sizeof(CookieBlock), true);
  if (mayFade(context)) builder.uniform("fading light", sizeof(RectifiedLightBlock), true);
}

TyBinding resultAt5(const LightClass& lights, bool add) {
  // A lone spot or point light may be left out of a frame, which a clearing pass before it provides for.
  return outputAt(5, add || lights.local ? TY_ACCESS_STORAGE_READ_WRITE : TY_ACCESS_STORAGE_WRITE);
}

bool mayFade(const LayoutContext& context) {
  return rectification(context.settings) != Rectification::kEpipolar && context.directionalLights > context.sunCookies;
}

std::vector<LightClass> lightClasses(const LayoutContext& context) {
  std::vector<LightClass> classes;
  // Images are shared: what is shown of them is of the map that comes last.
  if (mayFade(context)) classes.push_back({.fading = true});
  if (context.directionalLights > context.sunCookies) classes.push_back({false, false, false});
  if (context.sunCookies > 0) classes.push_back({false, true, true});
  if (context.localLights() > context.localCookies) classes.push_back({true, true, false});
  if (context.localCookies > 0) classes.push_back({true, true, true});
  return classes;
}

std::uint32_t rowsOf(const Settings& settings, const LightClass& lights) {
  return static_cast<std::uint32_t>(settings.columns) *
         (isProjective(settings, lights) ? static_cast<std::uint32_t>(settings.splits) : 1);
}

void beginClass(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights) {
  const Settings& settings = context.settings;
  builder.lights(lights.local ? kLocalLights : kSuns, lights.coloured, lights.fading);
  builder.substituteUniform(kLightBlock, lights.fading ? kFadingBlock : kLightBlock);
  builder.specializeAll({{13, isProjective(settings, lights) ? 1u : 0u},
                         {14, static_cast<SliceSpacing>(settings.slice_spacing) == SliceSpacing::kBorder ? 1u : 0u},
                         {15, lights.local ? 1u : 0u},
                         {27, lights.shaped ? 1u : 0u},
                         {28, lights.coloured ? 1u : 0u}});
}

TyBinding weightsAt20(const RectifyStage& stage) { return sampledAt(20, stage.weights); }
TyBinding unshadowedAt21(const RectifyStage& stage) { return sampledAt(21, stage.unshadowed); }
TyBinding litAt22(const RectifyStage& stage) {
  return sampledAt(22, stage.lit, stage.lights.shaped ? TY_SAMPLER_LINEAR_CLAMP : TY_SAMPLER_NEAREST_CLAMP);
}

RectifyStage addRectify(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights, DepthBits bits,
                        bool filterable, bool weighted) {
  const Settings& settings = context.settings;
  const auto columns = static_cast<std::uint32_t>(settings.columns);
  const auto rays = static_cast<std::uint32_t>(settings.reference_rays);
  const bool projective = isProjective(settings, lights);
  filterable &= !lights.local;
  MapPasses& passes = lights.fading ? builder.roles().fadingMap : builder.roles().map;
  RectifyStage stage;
  stage.lights = lights;
  stage.slices = static_cast<std::uint32_t>(settings.slices);
  stage.rows = rowsOf(settings, lights);
  stage.filtered = filterable && settings.filtered_resampling != 0 && context.shadowMoments != TY_FORMAT_UNKNOWN;
  builder.roles().momentsMissing |= filterable && settings.filtered_resampling != 0 && !stage.filtered;
  const TyFormat single = bits == DepthBits::k16 ? TY_FORMAT_R16_UNORM : TY_FORMAT_R32_FLOAT;
  const TyFormat pair = bits == DepthBits::k16 ? TY_FORMAT_RGBA16_UNORM : TY_FORMAT_RGBA32_FLOAT;

  stage.sliceBuffer = builder.buffer("slices", sizeof(Slice) * std::uint64_t{stage.slices});
  stage.rectified = builder.image("rectified", stage.filtered ? pair : single, stage.slices, stage.rows, 1, true);
  builder.compute(
      {"slices",
       "slices.comp",
       {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_WRITE)},
       (stage.slices + 63) / 64,
       1,
       1,
       kEachLight,
       {{0, rays}}});
  const std::vector<TyBinding> bindings{
      uniformAt(0, kLightBlock), bufferAt(1, stage.sliceBuffer, TY_ACCESS_STORAGE_READ),
      stage.filtered ? shadowMomentsAt(2) : shadowMapAt(2), storageAt(3, stage.rectified)};
  if (lights.local) {
    builder.compute(
        {"rectify", "rectify_local.comp", bindings, groups8(stage.slices), groups8(stage.rows), 1, kEachLight, {}});
  } else {
    const std::uint32_t pass = builder.compute(
        {"rectify",
         "rectify.comp",
         bindings,
         groups8(stage.slices),
         groups8(stage.rows),
         1,
         kEachLight,
         {{0, stage.filtered ? 1u : 0u}, {1, context.shadowMoments == TY_FORMAT_RGBA16_UNORM ? 1u : 0u}}});
    if (!lights.coloured) passes.rectifyPass = pass;
  }
  builder.debugView(
      "rectified",
      "Rectified map, resampled: slices along x, columns along y; depth of the first blocker, white = none",
      TY_SOURCE_IMAGE, stage.rectified, 0, 0, 0.0f, 1.0f, TY_VIEW_ROWS);
  if (stage.filtered) {
    builder.debugView("rectified_second", "Rectified map, filtered: depth of the second blocker", TY_SOURCE_IMAGE,
                      stage.rectified, 0, 1, 0.0f, 1.0f, TY_VIEW_ROWS);
    builder.debugView("rectified_share", "Rectified map, filtered: share of the second blocker", TY_SOURCE_IMAGE,
                      stage.rectified, 0, 2, 0.0f, 1.0f, TY_VIEW_ROWS);
    builder.debugView("shadow_moments",
                      "The first light's moment shadow map that the rows are made of, first three channels",
                      TY_SOURCE_SHADOW_MOMENTS, 0, 0, 4, 0.0f, 1.0f);
  }
  stage.projective = stage.weights = stage.lit = stage.unshadowed = stage.rectified;
  if (lights.local) {
    stage.unshadowed = builder.image("unshadowed", TY_FORMAT_R32_FLOAT, kUnshadowedSize, kUnshadowedSize, 1, true);
    builder.compute({"unshadowed",
                     "unshadowed.comp",
                     {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), storageAt(2, stage.unshadowed)},
                     kUnshadowedSize,
                     1,
                     1,
                     kEachLight,
                     {}});
    builder.debugView("unshadowed",
                      "Table of unshadowed integrals of a spot or point light: share of the angles at the light along "
                      "x, inclination along y",
                      TY_SOURCE_IMAGE, stage.unshadowed, 0, 0, 0.0f, 0.2f);
  }
  if (lights.shaped && weighted) addShine(builder, stage, rays, settings);
  if (!projective) return stage;

  const auto splits = static_cast<std::uint32_t>(settings.splits);
  stage.projective = builder.image("projective", TY_FORMAT_D32_FLOAT, stage.slices, columns, splits, true);
  passes.splits = splits;
  for (std::uint32_t i = 0; i < splits; ++i) {
    const std::string name = (lights.fading ? "fading split " : "split ") + std::to_string(i);
    const std::uint32_t block = builder.uniform(name, sizeof(glm::mat4), true);
    const std::uint32_t pass = builder.casters("rectify linear " + std::to_string(i), stage.projective, i, block);
    if (i == 0) passes.casterBlock = block;
    if (i == 0) passes.casterPass = pass;
    builder.debugView("projective_" + std::to_string(i),
                      "Rectified map, rasterised, of split " + std::to_string(i) +
                          ": slices along x, columns along y; white = no blocker",
                      TY_SOURCE_IMAGE, stage.projective, i, 0, 0.0f, 1.0f, splits == 1 ? TY_VIEW_ROWS : TY_VIEW_PLAIN);
  }
  return stage;
}

void prepareRectify(const FrameContext& context, bool parted) {
  Settings settings = context.settings;
  if (!parted) settings.regions = 1;
  auto& frame = context.block<RectifiedBlock>(kFrameBlock);
  frame.rays = rayBlock(*context.frame.view, settings);
  frame.rectified.reference_ray = settings.reference_ray;
  frame.rectified.weights = settings.weights;
  frame.rectified.near_correction = settings.near_correction;
  frame.rectified.epipole_block = settings.epipole_block;
  frame.rectified.column_spacing = settings.column_spacing;
  bool anyLocal = false;
  const auto isMain = [](const ClassPasses& passes) { return !passes.fading; };
  const auto classes = std::count_if(context.roles.classes.begin(), context.roles.classes.end(), isMain);
  const bool fadingPasses = classes < static_cast<std::ptrdiff_t>(context.roles.classes.size());
  for (std::uint32_t i = 0; i < context.frame.light_count; ++i) {
    const TyLight& light = context.frame.lights[i];
    auto& block = context.block<RectifiedLightBlock>(kLightBlock, i);
    auto* fading = fadingPasses ? &context.block<RectifiedLightBlock>(kFadingBlock, i) : nullptr;
    RectificationInput input;
    input.rays = frame.rays;
    input.columns = static_cast<std::uint32_t>(settings.columns);
    input.slices = static_cast<std::uint32_t>(settings.slices);
    input.spacing = static_cast<SliceSpacing>(settings.slice_spacing);
    block.cookie = context.block<CookieBlock>(kCookieBlock, i) = cookieBlock(light, frame.rays.eye);
    // A technique with a single class takes all lights of its kinds for it.
    for (const ClassPasses& passes : context.roles.classes)
      if (!passes.fading && classes > 1 && (passes.kinds >> light.kind & 1u) != 0 &&
          passes.cookie != (block.cookie.faces != 0))
        for (const std::uint32_t pass : passes.passes) context.skip(pass, i);
    bool fades = false;
    if (light.kind == TY_LIGHT_DIRECTIONAL) {
      block.sun = sunBlock(light, frame.rays.eye);
      input.towards = block.sun.towards;
      input.wholeView = block.cookie.faces != 0;
      for (std::size_t corner = 0; corner < 8; ++corner)
        input.casterCorners[corner] = glm::make_vec3(light.caster_corners[corner]);
      fades = chooseMaps(context, settings, input, i, parted, block, fading);
      const glm::vec3 a = block.sun.towards;
      block.map.shadowAlong = block.sun.shadowX * a.x + block.sun.shadowY * a.y + block.sun.shadowZ * a.z;
      if (fades) fading->map.shadowAlong = block.map.shadowAlong;
    } else {
      block.local = localBlock(light, frame.rays.eye);
      context.block<LocalBlock>(kLocalBlock, i) = block.local;
      if (reachesView(block.local, frame.rays)) {
        anyLocal = true;
      } else {
        for (const std::uint32_t pass : context.roles.localPasses) context.skip(pass, i);
        continue;
      }
      setLeastWeights(light, frame.rays.eye, settings.sigma_t, block);
      const float distance = glm::length(block.local.position);
      block.nearby = std::clamp((kFarFromEye - distance) / (kFarFromEye - kNearEye), 0.0f, 1.0f);
      if (block.nearby >= 1)
        for (const std::uint32_t pass : context.roles.localRowPasses) context.skip(pass, i);
      // The axis needs a length and a direction.
      block.distance = std::max(distance, kLeastLampDistance);
      block.sun.towards = input.towards =
          distance < kLeastLampDistance ? -frame.rays.forward : block.local.position / distance;
      if (light.kind == TY_LIGHT_SPOT) {
        input.coneAxis = block.local.axis;
        input.sinOuter = block.local.sinOuter;
      }
      shareOfScreen(context, input, i, block.local);
      block.map = epipolarBlock(input);
      setSegments(block.map, static_cast<std::uint32_t>(settings.regions));
      block.map.depthPower = 1.0f / (1.0f + settings.depth_warp);
      block.thetaLow = std::max(block.map.depthLow, 0.0f);
      block.thetaHigh = std::min(block.map.depthLow + 1 / block.map.depthScale, std::numbers::pi_v<float>);
    }
    block.epipoles = glm::vec4(onScreen(frame.rays, block.sun.towards), onScreen(frame.rays, -block.sun.towards));
    if (fades) {
      const RectificationBlock map = fading->map;
      *fading = block;
      fading->map = map;
    }
    for (const ClassPasses& passes : context.roles.classes)
      if (passes.fading && !fades)
        for (const std::uint32_t pass : passes.passes) context.skip(pass, i);
  }
  // The only light's pass writes the result itself, or else the clearing pass does.
  if (anyLocal && context.roles.standInClear != TY_NONE) context.skip(context.roles.standInClear, 0);
}

}  // namespace volumetrics
