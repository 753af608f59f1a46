#include "stages/rectify.hpp"

#include <glm/gtc/type_ptr.hpp>

#include "geometry/camera_rays.hpp"
#include "geometry/epipolar_frame.hpp"
#include "stages/suns.hpp"

namespace volumetrics {

RectifyStage addRectify(const LayoutContext& context, LayoutBuilder& builder, std::uint32_t frameBlock, std::uint32_t sunBlock,
                        TyFormat format) {
  const auto slices = static_cast<std::uint32_t>(context.settings.slices);
  const auto columns = static_cast<std::uint32_t>(context.settings.columns);
  const auto rays = static_cast<std::uint32_t>(context.settings.reference_rays);
  RectifyStage stage;
  stage.sliceBuffer = builder.buffer("slices", sizeof(Slice) * std::uint64_t{slices});
  stage.rectified = builder.image("rectified", format, slices, columns);
  builder.compute({"slices", "slices.comp",
                   {uniformAt(0, frameBlock), uniformAt(1, sunBlock), bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_WRITE)},
                   (slices + 63) / 64, 1, 1, true, {{0, rays}}});
  builder.compute({"rectify", "rectify.comp",
                   {uniformAt(0, sunBlock), bufferAt(1, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), shadowMapAt(2),
                    storageAt(3, stage.rectified)},
                   groups8(slices), groups8(columns), 1, true, {}});
  builder.debugView("rectified", "Rectified map: slices along x, columns along y; inclination of the first blocker, white = none",
                    TY_SOURCE_IMAGE, stage.rectified, 0, 0, 0.0f, 1.0f);
  return stage;
}

void prepareRectify(const FrameContext& context, std::uint32_t frameBlock, std::uint32_t sunBlock_) {
  auto& frame = context.block<RectifiedBlock>(frameBlock);
  frame.rays = rayBlock(*context.frame.view, context.settings);
  frame.rectified.reference_ray = context.settings.reference_ray;
  frame.rectified.weights = context.settings.weights;
  for (std::uint32_t i = 0; i < context.frame.light_count; ++i) {
    const TyLight& light = context.frame.lights[i];
    if (light.kind != TY_LIGHT_DIRECTIONAL) continue;
    auto& block = context.block<RectifiedSunBlock>(sunBlock_, i);
    block.sun = sunBlock(light, frame.rays.eye);
    EpipolarInput input;
    input.rays = frame.rays;
    input.towards = block.sun.towards;
    for (std::size_t corner = 0; corner < 8; ++corner) input.casterCorners[corner] = glm::make_vec3(light.caster_corners[corner]);
    input.columns = static_cast<std::uint32_t>(context.settings.columns);
    input.slices = static_cast<std::uint32_t>(context.settings.slices);
    block.epipolar = epipolarBlock(input);
    const glm::vec3 a = block.sun.towards;
    block.epipolar.shadowAlong = block.sun.shadowX * a.x + block.sun.shadowY * a.y + block.sun.shadowZ * a.z;
  }
}

}  // namespace volumetrics
