// exact by rows in the order of depth. Kernels: stages/slices, stages/rectify, strength, order_build or order_scan,
// order_evaluate.
#include "techniques/exact/depth_order.hpp"

#include <algorithm>
#include <bit>

#include "stages/debug_views.hpp"
#include "stages/suns.hpp"

namespace volumetrics {
namespace {

constexpr std::uint32_t kMostBinBits = 12;
/// Columns whose records one invocation makes in a pass: a device may end loops after 65,535 iterations.
constexpr std::uint32_t kColumnsAPass = 2048;

/// Shape of the rows: what order_rows.glsl is specialized with.
struct Shape {
  std::uint32_t bits, binBits, blockBits;
  bool wide;  ///< 16 bits a count
  bool byColumn;
  std::uint32_t elements() const { return 1u << bits; }
  std::uint32_t countWords() const { return (wide ? 16u : 8u) * (1u << blockBits) / 32; }
  std::uint32_t recordTexels() const { return (countWords() + blockBits + 3) / 4; }
  std::uint32_t placeBits() const { return bits - blockBits; }
  std::uint32_t placeTexels() const { return (placeBits() + 3) / 4; }
  std::vector<TySpecialization> constants() const {
    return {{16, bits}, {18, binBits}, {29, blockBits}, {30, wide ? 1u : 0u}};
  }
};

Shape shapeOf(const Settings& settings, std::uint32_t columns) {
  Shape shape{};
  shape.bits = static_cast<std::uint32_t>(std::bit_width(columns - 1));
  shape.binBits = std::min(shape.bits + 1, kMostBinBits);
  const auto blocks = static_cast<RowBlocks>(settings.row_blocks);
  shape.byColumn = blocks == RowBlocks::kColumns;
  shape.blockBits = shape.byColumn ? 5u : 3u + static_cast<std::uint32_t>(settings.row_blocks);
  shape.blockBits = std::min(shape.blockBits, shape.bits - 1);
  shape.wide = shape.placeBits() >= 8;
  return shape;
}

/// What every device has at least (Vulkan 1.3, required limits).
constexpr std::uint32_t kLeastSharedBytes = 16384, kLeastInvocations = 128;
/// Columns of an invocation of the workgroup that builds a row: found for the wavelet matrix, not measured anew.
constexpr std::uint32_t kScanColumns = 8;
constexpr std::uint32_t kMostScanLanes = 512;

/// Invocations of a workgroup that builds one row (order_scan.comp); 0: shared memory does not hold a row. A software
/// device has nothing to hide latency behind, so there it is one subgroup.
std::uint32_t scanLanes(const TyDevice& device, const Shape& shape) {
  const std::uint32_t subgroup = std::bit_floor(std::max(device.subgroup_size, 1u));
  const std::uint32_t most =
      std::min(std::bit_floor(std::max(device.max_workgroup_invocations, kLeastInvocations)), kMostScanLanes);
  const std::uint32_t lanes =
      device.is_cpu != 0 ? subgroup : std::clamp(shape.elements() / kScanColumns, subgroup, std::max(most, subgroup));
  const std::uint32_t records = shape.elements() / 32;
  const std::uint32_t words = (1u << shape.binBits) + 1 + shape.elements() +
                              records * (shape.blockBits + shape.countWords() + shape.placeBits()) + 1 + lanes;
  return 4 * words <= std::max(device.max_shared_memory, kLeastSharedBytes) ? lanes : 0;
}

bool wantsScan(const Settings& settings) {
  return static_cast<PrefixScheme>(settings.prefix_scheme) == PrefixScheme::kScan;
}

/// Images of a row.
struct Images {
  std::uint32_t ranks, order, places;
};

void addBuild(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage, const Shape& shape,
              const Images& images) {
  const std::vector<TyBinding> bindings{uniformAt(1, kLightBlock),      sampledAt(3, stage.rectified),
                                        sampledAt(4, stage.projective), storageAt(5, images.order),
                                        storageAt(6, images.places),    storageAt(7, images.ranks)};
  const std::uint32_t lanes = wantsScan(context.settings) ? scanLanes(context.device, shape) : 0;
  builder.roles().scanImpossible |= wantsScan(context.settings) && lanes == 0;
  if (lanes > 0) {
    ComputePass pass{"build", "order_scan.comp", bindings, stage.slices, 1, 1, kEachLight, shape.constants()};
    pass.specializations.push_back({10, lanes});
    builder.compute(std::move(pass));
    return;
  }
  const bool onStack = context.device.is_cpu != 0 && shape.elements() <= kColumnsAPass;
  const std::uint32_t groups = (stage.slices + 31) / 32;
  const std::uint64_t words =
      shape.elements() + (1u << shape.binBits) + 1 + shape.countWords() + shape.elements() / 32 * shape.placeBits();
  const std::uint32_t scratch = builder.buffer("order scratch", onStack ? 4 : 4 * words * groups * 32);
  for (std::uint32_t first = 0; first < shape.elements(); first += kColumnsAPass) {
    ComputePass pass{"build", "order_build.comp", bindings, groups, 1, 1, kEachLight, shape.constants()};
    pass.bindings.push_back(bufferAt(9, scratch, TY_ACCESS_STORAGE_WRITE));
    for (const auto& [id, value] :
         {std::pair{20u, first}, {21u, std::min(first + kColumnsAPass, shape.elements())}, {25u, onStack ? 1u : 0u}})
      pass.specializations.push_back({id, value});
    builder.compute(std::move(pass));
  }
}

}  // namespace

void addDepthOrder(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights, bool add) {
  const Settings& settings = context.settings;
  beginClass(context, builder, lights);
  const RectifyStage stage = addRectify(context, builder, lights, DepthBits::k16, false, false);
  const Shape shape = shapeOf(settings, stage.rows);
  const std::uint32_t records = shape.elements() / 32;
  const std::uint32_t ranks = builder.image("ranks", TY_FORMAT_R16_UNORM, stage.slices, (1u << shape.binBits) + 1);
  const std::uint32_t order =
      builder.image("order", TY_FORMAT_RGBA32_UINT, stage.slices, records * shape.recordTexels());
  const std::uint32_t places =
      builder.image("places", TY_FORMAT_RGBA32_UINT, stage.slices, records * shape.placeTexels());
  const TyBinding slices = bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_READ);

  std::uint32_t strengths = stage.rectified;
  if (lights.shaped) {
    strengths = builder.image("strengths", TY_FORMAT_RGBA16_UNORM, stage.slices, stage.rows, 1, true);
    builder.compute({"strength",
                     "strength.comp",
                     {uniformAt(1, kLightBlock), slices, lightCookieAt(3, lights.coloured), storageAt(4, strengths)},
                     (stage.slices + 31) / 32,
                     1u << shape.blockBits,
                     1,
                     kEachLight,
                     shape.constants()});
    builder.debugView("strengths", "Strength and colour of a slice's light rays, from the start of a block up to each",
                      TY_SOURCE_IMAGE, strengths, 0, lights.coloured ? 4 : 0, 0.0f, 1.0f, TY_VIEW_ROWS);
  }

  addBuild(context, builder, stage, shape, {ranks, order, places});

  const auto evaluate = [&](const char* name, const TyBinding& result, bool first, bool steps) {
    ComputePass pass{name,
                     "order_evaluate.comp",
                     {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sceneDepthAt(2),
                      bufferAt(3, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), shadowMapAt(4), result,
                      sampledAt(6, order), sampledAt(7, places), sampledAt(8, strengths), sampledAt(10, ranks),
                      unshadowedAt21(stage), lightCookieAt(23, lights.coloured)},
                     groups8(context.structure.width),
                     groups8(context.structure.height),
                     1,
                     kEachLight,
                     shape.constants()};
    for (const auto& [id, value] : {std::pair{5u, static_cast<std::uint32_t>(settings.row_filter)},
                                    {6u, first ? 1u : 0u},
                                    {7u, steps ? 1u : 0u},
                                    {31u, shape.byColumn ? 1u : 0u}})
      pass.specializations.push_back({id, value});
    builder.compute(std::move(pass));
  };
  evaluate("evaluate", resultAt5(lights, add), !add, false);

  const std::uint32_t steps =
      builder.image("steps", TY_FORMAT_RGBA32_FLOAT, context.structure.width, context.structure.height);
  evaluate("debug steps", storageAt(5, steps), true, true);
  builder.debugView("steps", "Blocks and parts of blocks looked at by each pixel's ray, both rows together",
                    TY_SOURCE_IMAGE, steps, 0, 0, 0.0f, 128.0f);
  builder.debugView("ranks", "How many of a slice's depths lie before each depth (downwards); white = all",
                    TY_SOURCE_IMAGE, ranks, 0, 0, 0.0f, static_cast<float>(shape.elements()) / 65535.0f);
  addRowViews(context, builder, stage);
}

void addDepthOrderTunable(const LayoutContext& context, LayoutBuilder& builder) {
  const std::vector<LightClass> classes = lightClasses(context);
  std::vector<double> schemes{static_cast<double>(PrefixScheme::kRow)};
  if (std::all_of(classes.begin(), classes.end(), [&](const LightClass& lights) {
        return scanLanes(context.device, shapeOf(context.settings, rowsOf(context.settings, lights))) > 0;
      }))
    schemes.push_back(static_cast<double>(PrefixScheme::kScan));
  if (!classes.empty())
    builder.tunable(prefixSchemeIndex(), static_cast<double>(PrefixScheme::kAuto), schemes, {"build"});
}

}  // namespace volumetrics
