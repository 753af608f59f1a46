#include "stages/rectify.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <glm/gtc/type_ptr.hpp>

#include "geometry/camera_rays.hpp"
#include "geometry/linear_frame.hpp"
#include "stages/suns.hpp"

namespace volumetrics {
namespace {

/// Segments are whole multiples of this, so that three mip levels never mix two of them.
constexpr std::uint32_t kSegmentAlignment = 8;

Rectification rectification(const Settings& settings) { return static_cast<Rectification>(settings.rectification); }

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

/// An epipolar map that stands in for projective ones is parted where they would be, so that a switch between both changes neither the
/// number of look-ups nor what joining them brings. `projective`: the projective map, if there is one for this view.
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
      map.segmentDistance[split * regions + region] = static_cast<float>(1 / ((1 - share) / along[split] + share / along[split + 1]));
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

/// Chooses the map of this frame, parts it, and fills the matrices of its splits if it is projective.
RectificationBlock chooseMap(const FrameContext& context, const RectificationInput& input, std::uint32_t light) {
  const Settings& settings = context.settings;
  const std::uint32_t splits = context.roles.splits;
  std::optional<LinearFrame> linear;
  if (rectification(settings) != Rectification::kEpipolar) linear = linearFrame(input, splits);
  const bool useLinear = linear && (rectification(settings) == Rectification::kLinear || isEvenEnough(*linear));
  context.report.linearImpossible |= !linear && rectification(settings) == Rectification::kLinear;

  RectificationInput wide = input;
  wide.columns *= std::max(1u, splits);
  RectificationBlock map = useLinear ? linear->block : epipolarBlock(wide);
  const auto regions = static_cast<std::uint32_t>(settings.regions);
  if (!useLinear && splits > 1 && map.reach > 0)
    setSegmentsByDistance(map, splits, regions, input.rays.znear, linear);
  else
    setSegments(map, regions);
  if (useLinear) context.skip(context.roles.rectifyPass, light);
  for (std::uint32_t i = 0; i < splits; ++i) {
    context.block<glm::mat4>(context.roles.casterBlock + i, light) = useLinear ? linear->clipFromWorld[i] : glm::mat4(0.0f);
    if (!useLinear || map.polygonCount == 0) context.skip(context.roles.casterPass + i, light);
  }
  return map;
}

}  // namespace

void addRowBlocks(const Settings& settings, LayoutBuilder& builder) {
  builder.specializeAll({{13, rectification(settings) != Rectification::kEpipolar ? 1u : 0u},
                         {14, static_cast<SliceSpacing>(settings.slice_spacing) == SliceSpacing::kBorder ? 1u : 0u}});
  builder.uniform("frame", sizeof(RectifiedBlock), false);
  builder.uniform("sun", sizeof(RectifiedSunBlock), true);
}

RectifyStage addRectify(const LayoutContext& context, LayoutBuilder& builder, DepthBits bits, bool filterable) {
  const Settings& settings = context.settings;
  const auto columns = static_cast<std::uint32_t>(settings.columns);
  const auto rays = static_cast<std::uint32_t>(settings.reference_rays);
  const bool projective = rectification(settings) != Rectification::kEpipolar;
  RectifyStage stage;
  stage.slices = static_cast<std::uint32_t>(settings.slices);
  stage.rows = columns * (projective ? static_cast<std::uint32_t>(settings.splits) : 1);
  stage.filtered = filterable && settings.filtered_resampling != 0 && context.shadowMoments != TY_FORMAT_UNKNOWN;
  builder.roles().momentsMissing = filterable && settings.filtered_resampling != 0 && !stage.filtered;
  const TyFormat single = bits == DepthBits::k16 ? TY_FORMAT_R16_UNORM : TY_FORMAT_R32_FLOAT;
  const TyFormat pair = bits == DepthBits::k16 ? TY_FORMAT_RGBA16_UNORM : TY_FORMAT_RGBA32_FLOAT;

  stage.sliceBuffer = builder.buffer("slices", sizeof(Slice) * std::uint64_t{stage.slices});
  stage.rectified = builder.image("rectified", stage.filtered ? pair : single, stage.slices, stage.rows, 1, true);
  builder.compute({"slices", "slices.comp",
                   {uniformAt(0, kFrameBlock), uniformAt(1, kSunBlock), bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_WRITE)},
                   (stage.slices + 63) / 64, 1, 1, true, {{0, rays}}});
  builder.roles().rectifyPass = builder.compute(
      {"rectify", "rectify.comp",
       {uniformAt(0, kSunBlock), bufferAt(1, stage.sliceBuffer, TY_ACCESS_STORAGE_READ),
        stage.filtered ? shadowMomentsAt(2) : shadowMapAt(2), storageAt(3, stage.rectified)},
       groups8(stage.slices), groups8(stage.rows), 1, true,
       {{0, stage.filtered ? 1u : 0u}, {1, context.shadowMoments == TY_FORMAT_RGBA16_UNORM ? 1u : 0u}}});
  builder.debugView("rectified", "Rectified map, resampled: slices along x, columns along y; depth of the first blocker, white = none",
                    TY_SOURCE_IMAGE, stage.rectified, 0, 0, 0.0f, 1.0f);
  if (stage.filtered) {
    builder.debugView("rectified_second", "Rectified map, filtered: depth of the second blocker", TY_SOURCE_IMAGE, stage.rectified, 0, 1,
                      0.0f, 1.0f);
    builder.debugView("rectified_share", "Rectified map, filtered: share of the second blocker", TY_SOURCE_IMAGE, stage.rectified, 0, 2,
                      0.0f, 1.0f);
    builder.debugView("shadow_moments", "The first light's moment shadow map that the rows are made of, first three channels",
                      TY_SOURCE_SHADOW_MOMENTS, 0, 0, 4, 0.0f, 1.0f);
  }
  stage.projective = stage.rectified;
  if (!projective) return stage;

  const auto splits = static_cast<std::uint32_t>(settings.splits);
  stage.projective = builder.image("projective", TY_FORMAT_D32_FLOAT, stage.slices, columns, splits, true);
  builder.roles().splits = splits;
  for (std::uint32_t i = 0; i < splits; ++i) {
    const std::string name = "split " + std::to_string(i);
    const std::uint32_t block = builder.uniform(name, sizeof(glm::mat4), true);
    const std::uint32_t pass = builder.casters("rectify linear " + std::to_string(i), stage.projective, i, block);
    if (i == 0) builder.roles().casterBlock = block;
    if (i == 0) builder.roles().casterPass = pass;
    builder.debugView("projective_" + std::to_string(i),
                      "Rectified map, rasterised, of split " + std::to_string(i) + ": slices along x, columns along y; white = no blocker",
                      TY_SOURCE_IMAGE, stage.projective, i, 0, 0.0f, 1.0f);
  }
  return stage;
}

void prepareRectify(const FrameContext& context) {
  const Settings& settings = context.settings;
  auto& frame = context.block<RectifiedBlock>(kFrameBlock);
  frame.rays = rayBlock(*context.frame.view, settings);
  frame.rectified.reference_ray = settings.reference_ray;
  frame.rectified.weights = settings.weights;
  frame.rectified.near_correction = settings.near_correction;
  frame.rectified.epipole_block = settings.epipole_block;
  for (std::uint32_t i = 0; i < context.frame.light_count; ++i) {
    const TyLight& light = context.frame.lights[i];
    if (light.kind != TY_LIGHT_DIRECTIONAL) continue;
    auto& block = context.block<RectifiedSunBlock>(kSunBlock, i);
    block.sun = sunBlock(light, frame.rays.eye);
    RectificationInput input;
    input.rays = frame.rays;
    input.towards = block.sun.towards;
    for (std::size_t corner = 0; corner < 8; ++corner) input.casterCorners[corner] = glm::make_vec3(light.caster_corners[corner]);
    input.columns = static_cast<std::uint32_t>(settings.columns);
    input.slices = static_cast<std::uint32_t>(settings.slices);
    input.spacing = static_cast<SliceSpacing>(settings.slice_spacing);
    block.map = chooseMap(context, input, i);
    block.map.depthPower = 1.0f / (1.0f + settings.depth_warp);
    const glm::vec3 a = block.sun.towards;
    block.map.shadowAlong = block.sun.shadowX * a.x + block.sun.shadowY * a.y + block.sun.shadowZ * a.z;
    block.epipoles = glm::vec4(onScreen(frame.rays, a), onScreen(frame.rays, -a));
  }
}

}  // namespace volumetrics
