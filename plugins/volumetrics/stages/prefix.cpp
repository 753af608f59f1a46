#include "stages/prefix.hpp"

#include <algorithm>
#include <bit>

#include "stages/suns.hpp"

namespace volumetrics {
namespace {

/// Invocations of the workgroup scan: eight rows, and as many runs a row as shared memory holds.
constexpr std::uint32_t kScanRows = 8, kMostScanRuns = 32;
/// What every device has at least (Vulkan 1.3, required limits).
constexpr std::uint32_t kLeastSharedBytes = 16384, kLeastInvocations = 128;

std::uint32_t scanRuns(const TyDevice& device, std::uint32_t vectors, std::uint32_t rays) {
  const std::uint32_t bytes = rays * (16 * vectors + 4) + 8;  // sums, total weights, range of one invocation
  const std::uint32_t fit = std::max(device.max_shared_memory, kLeastSharedBytes) / (bytes * kScanRows);
  const std::uint32_t most = std::max(device.max_workgroup_invocations, kLeastInvocations) / kScanRows;
  return std::bit_floor(std::max(1u, std::min({fit, most, kMostScanRuns})));
}

bool mipmapped(const Settings& settings) {
  return static_cast<RowFilter>(settings.row_filter) == RowFilter::kMipmapped;
}

void addMips(LayoutBuilder& builder, const RectifyStage& stage, std::uint32_t image, std::uint32_t layers) {
  for (std::uint32_t mip = 1; mip < kPrefixMips; ++mip)
    builder.compute({"prefix mip " + std::to_string(mip),
                     "mip.comp",
                     {mipOf(sampledAt(0, image, TY_SAMPLER_LINEAR_CLAMP), mip - 1),
                      mipOf(storageAt(1, image, TY_ACCESS_STORAGE_WRITE), mip)},
                     groups8(std::max(1u, stage.slices >> mip)),
                     groups8(std::max(1u, stage.rows >> mip)),
                     layers,
                     kEachLight,
                     {}});
}

}  // namespace

std::uint32_t prefixImage(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage,
                          const char* name, TyFormat format, std::uint32_t layers) {
  return builder.image(name, format, stage.slices, stage.rows, layers, true,
                       mipmapped(context.settings) ? kPrefixMips : 1);
}

std::uint32_t unusedImage(LayoutBuilder& builder, const char* name, TyFormat format) {
  return builder.image(name, format, 1, 1, 1, true);
}

void addPrefix(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage,
               const PrefixTechnique& technique, bool add) {
  const Settings& settings = context.settings;
  const auto rays = static_cast<std::uint32_t>(settings.reference_rays);
  const std::uint32_t bounded = settings.prefix_bounds != 0 ? 1 : 0;
  const std::uint32_t bounds = bounded != 0
                                   ? builder.image("prefix_bounds", TY_FORMAT_RG16_UNORM, stage.slices, stage.rows)
                                   : builder.image("prefix_bounds", TY_FORMAT_RG16_UNORM, 1, 1);

  // "auto" stands for the first variant until the host has timed all.
  const auto scheme = static_cast<PrefixScheme>(settings.prefix_scheme);
  const bool block = scheme == PrefixScheme::kBlock, scan = scheme == PrefixScheme::kScan;
  const std::uint32_t runs = scan ? scanRuns(context.device, technique.vectors, rays) : block ? 8 : 1;
  const std::uint32_t across = scan ? kScanRows : block ? 8 : 32;
  const auto columns = static_cast<std::uint32_t>(settings.columns);
  ComputePass prefix{
      "prefix",
      technique.prefixShader,
      {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_READ),
       sampledAt(3, stage.rectified), sampledAt(4, stage.projective), storageAt(5, bounds), weightsAt20(stage)},
      (stage.slices + across - 1) / across,
      stage.rows / columns * static_cast<std::uint32_t>(settings.regions),
      technique.groups,
      kEachLight,
      technique.prefixConstants};
  prefix.bindings.insert(prefix.bindings.end(), technique.extra.begin(), technique.extra.end());
  for (std::size_t i = 0; i < technique.images.size(); ++i)
    prefix.bindings.push_back(storageAt(6 + static_cast<std::uint32_t>(i), technique.images[i]));
  for (const auto& [id, value] : {std::pair{1u, rays},
                                  {3u, bounded},
                                  {7u, scan ? 1u : 0u},
                                  {8u, stage.filtered ? 1u : 0u},
                                  {9u, scan ? across * runs : 1u},
                                  {10u, across},
                                  {11u, runs},
                                  {12u, technique.compensated ? 1u : 0u}})
    prefix.specializations.push_back({id, value});
  builder.compute(std::move(prefix));
  if (mipmapped(settings))
    for (const std::uint32_t image : technique.images)
      if (builder.mipsOf(image) > 1) addMips(builder, stage, image, builder.layersOf(image));

  ComputePass evaluate{
      "evaluate",
      technique.evaluateShader,
      {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sceneDepthAt(2),
       bufferAt(3, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), shadowMapAt(4), resultAt5(stage.lights, add),
       sampledAt(6, bounds), unshadowedAt21(stage), litAt22(stage), lightCookieAt(23, stage.lights.coloured)},
      groups8(context.structure.width),
      groups8(context.structure.height),
      1,
      kEachLight,
      technique.evaluateConstants};
  for (std::size_t i = 0; i < technique.images.size(); ++i)
    evaluate.bindings.push_back(
        sampledAt(7 + static_cast<std::uint32_t>(i), technique.images[i],
                  mipmapped(settings) ? TY_SAMPLER_LINEAR_MIPMAP_CLAMP : TY_SAMPLER_LINEAR_CLAMP));
  for (const auto& [id, value] :
       {std::pair{1u, rays}, {3u, bounded}, {5u, static_cast<std::uint32_t>(settings.row_filter)}, {6u, add ? 0u : 1u}})
    evaluate.specializations.push_back({id, value});
  builder.compute(std::move(evaluate));

  if (bounded != 0) {
    builder.debugView("prefix_min", "Prefix minimum of the depth of the first blocker: rays below it are lit",
                      TY_SOURCE_IMAGE, bounds, 0, 0, 0.0f, 1.0f, TY_VIEW_ROWS);
    builder.debugView("prefix_max", "Prefix maximum of the depth of the first blocker: rays above it are shadowed",
                      TY_SOURCE_IMAGE, bounds, 0, 1, 0.0f, 1.0f, TY_VIEW_ROWS);
  }
  builder.tunable(prefixSchemeIndex(), static_cast<double>(PrefixScheme::kAuto),
                  {static_cast<double>(PrefixScheme::kRow), static_cast<double>(PrefixScheme::kBlock),
                   static_cast<double>(PrefixScheme::kScan)},
                  {"prefix"});
}

}  // namespace volumetrics
