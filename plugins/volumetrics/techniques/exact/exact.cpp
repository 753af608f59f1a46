// exact: layout and uniforms. Kernels: stages/slices, stages/rectify, exact_build or exact_scan, exact_evaluate.
#include <algorithm>
#include <array>
#include <bit>

#include "layout_builder.hpp"
#include "stages/debug_views.hpp"
#include "stages/suns.hpp"
#include "technique.hpp"
#include "techniques/exact/depth_order.hpp"

namespace volumetrics {
namespace {

constexpr std::array kReads = {TY_RECTIFY_READS,        "volumetrics.reference_rays", "volumetrics.reference_ray",
                               "volumetrics.weights",   "volumetrics.prefix_bounds",  "volumetrics.prefix_scheme",
                               "volumetrics.precision", "volumetrics.levels",         "volumetrics.row_order",
                               "volumetrics.row_blocks"};

/// A device may end loops after so many iterations of one invocation; some are left for what is not counted here.
constexpr std::uint32_t kMostIterations = 60000;
/// Levels that an invocation a row builds in the block scheme, before an invocation a node takes over: 8 nodes a row.
constexpr std::uint32_t kRowLevels = 3;
constexpr std::uint32_t kMostBinBits = 12;
/// What every device has at least (Vulkan 1.3, required limits).
constexpr std::uint32_t kLeastSharedBytes = 16384, kLeastInvocations = 128;
/// Elements of an invocation of the scan: few enough for registers, enough for levels that need no other invocation.
constexpr std::uint32_t kScanElements = 8;
constexpr std::uint32_t kMostScanLanes = 512;

/// Shape of the matrices: what tree.glsl and the shaders are specialized with.
struct Matrix {
  std::uint32_t bits, levels, binBits;
  std::uint32_t channels;  ///< shares a position: reference rays times colours
  std::uint32_t vectors;   ///< texels a position
  std::uint32_t elements() const { return 1u << bits; }
};

Matrix matrixOf(const Settings& settings, std::uint32_t columns, const LightClass& lights) {
  Matrix matrix{};
  matrix.bits = static_cast<std::uint32_t>(std::bit_width(columns - 1));
  matrix.levels =
      settings.levels == 0 ? matrix.bits : std::min(static_cast<std::uint32_t>(settings.levels), matrix.bits);
  matrix.binBits = std::min(matrix.bits + 1, kMostBinBits);
  matrix.channels = static_cast<std::uint32_t>(settings.reference_rays) * (lights.coloured ? 3 : 1);
  matrix.vectors = (matrix.channels + 4) / 4;
  return matrix;
}

/// Levels [first, last) that one pass of exact_build.comp builds.
struct LevelRange {
  std::uint32_t first, last;
};

/// Passes of exact_build.comp that build all levels: as few as a device's limit of iterations allows, or, for the block
/// scheme, so that all but the first levels are built by many invocations a row on little memory each.
std::vector<LevelRange> buildPasses(const Matrix& matrix, bool block) {
  const std::uint32_t sorting = 2 * matrix.elements() + 2 * (1u << matrix.binBits);
  if (!block && sorting + matrix.levels * matrix.elements() <= kMostIterations) return {{0, matrix.levels}};
  const std::uint32_t row = std::min(kRowLevels, matrix.levels);
  std::vector<LevelRange> passes;
  if (sorting + row * matrix.elements() > kMostIterations) passes.push_back({0, 0});
  passes.push_back({0, row});
  if (matrix.levels > row) passes.push_back({row, matrix.levels});
  return passes;
}

/// A workgroup that builds one row: invocations, and whether its texels fit in shared memory beside the row.
struct Scan {
  std::uint32_t lanes = 0;  ///< 0: shared memory does not hold a row
  bool staged = false;
};

/// A software device has nothing to hide latency behind, so there one subgroup builds a row.
Scan scanOf(const TyDevice& device, const Matrix& matrix, bool sixteenBit) {
  const std::uint32_t shared = std::max(device.max_shared_memory, kLeastSharedBytes);
  const std::uint32_t subgroup = std::bit_floor(std::max(device.subgroup_size, 1u));
  const std::uint32_t most =
      std::min(std::bit_floor(std::max(device.max_workgroup_invocations, kLeastInvocations)), kMostScanLanes);
  Scan scan;
  scan.lanes =
      device.is_cpu != 0 ? subgroup : std::clamp(matrix.elements() / kScanElements, subgroup, std::max(most, subgroup));
  scan.lanes = std::min(scan.lanes, matrix.elements() / 2);
  const std::uint32_t quads = (1 + 2 * matrix.channels + 3) / 4;
  const std::uint32_t own = matrix.elements() / scan.lanes;
  const auto padded = [own](std::uint32_t items) { return items + items / own; };
  const std::uint32_t bytes = 4 * padded(matrix.elements()) + scan.lanes * (32 * quads + 8) + 8;
  // Subgroups must be whole.
  if (bytes > shared || scan.lanes % subgroup != 0) return {};
  scan.staged = sixteenBit && device.is_cpu == 0 && bytes + 8 * padded(matrix.elements() * matrix.vectors) <= shared;
  return scan;
}

std::vector<TySpecialization> constantsOf(const Matrix& matrix, const Settings& settings, bool scanned) {
  return {{1, static_cast<std::uint32_t>(settings.reference_rays)},
          {3, settings.prefix_bounds != 0 ? 1u : 0u},
          {16, matrix.bits},
          {17, matrix.levels},
          {18, matrix.binBits},
          {19, matrix.vectors},
          {24, scanned ? 1u : 0u}};
}

struct Images {
  std::uint32_t bounds, levels, ranks;
};

void addBuild(const LayoutContext& context, LayoutBuilder& builder, const RectifyStage& stage, const Matrix& matrix,
              const Scan& scan, const Images& images) {
  const std::vector<TySpecialization> constants = constantsOf(matrix, context.settings, scan.lanes > 0);
  const std::vector<TyBinding> bindings{uniformAt(0, kFrameBlock),
                                        uniformAt(1, kLightBlock),
                                        bufferAt(2, stage.sliceBuffer, TY_ACCESS_STORAGE_READ),
                                        sampledAt(3, stage.rectified),
                                        sampledAt(4, stage.projective),
                                        storageAt(5, images.bounds),
                                        storageAt(6, images.levels),
                                        storageAt(7, images.ranks),
                                        weightsAt20(stage)};
  if (scan.lanes > 0) {
    ComputePass pass{"build", "exact_scan.comp", bindings, stage.slices, 1, 1, kEachLight, constants};
    pass.specializations.push_back({10, scan.lanes});
    pass.specializations.push_back({26, scan.staged ? matrix.elements() * matrix.vectors : 1});
    builder.compute(std::move(pass));
    return;
  }
  const std::vector<LevelRange> passes =
      buildPasses(matrix, static_cast<PrefixScheme>(context.settings.prefix_scheme) != PrefixScheme::kRow);
  // Between two passes the order of columns is kept here; a single texel stands in where it is never touched.
  const bool several = passes.size() > 1;
  const std::uint32_t order =
      builder.image("order", TY_FORMAT_R32_UINT, several ? stage.slices : 1, several ? matrix.elements() : 1);
  // A CPU's private arrays lie in its cache; a GPU's would not fit (some drivers refuse the pipeline).
  const bool onStack = context.device.is_cpu != 0;
  const std::uint32_t groups = (stage.slices + 31) / 32;
  const std::uint64_t words = 2 * matrix.elements() + (1u << matrix.binBits) + 1;
  const std::uint32_t scratch = builder.buffer("scratch", onStack ? 4 : 4 * words * groups * 32);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const auto& [first, last] = passes[i];
    ComputePass pass{"build", "exact_build.comp", bindings, groups, 1u << first, 1, kEachLight, constants};
    pass.bindings.push_back(storageAt(8, order, i == 0 ? TY_ACCESS_STORAGE_WRITE : TY_ACCESS_STORAGE_READ_WRITE));
    pass.bindings.push_back(bufferAt(9, scratch, TY_ACCESS_STORAGE_WRITE));
    for (const auto& [id, value] : {std::pair{20u, first},
                                    {21u, last},
                                    {22u, i == 0 ? 1u : 0u},
                                    {23u, i + 1 < passes.size() ? 1u : 0u},
                                    {25u, onStack ? 1u : 0u}})
      pass.specializations.push_back({id, value});
    builder.compute(std::move(pass));
  }
}

void addClass(const LayoutContext& context, LayoutBuilder& builder, const LightClass& lights, bool add) {
  const Settings& settings = context.settings;
  beginClass(context, builder, lights);
  const RectifyStage stage = addRectify(context, builder, lights, DepthBits::k16, false);
  const Matrix matrix = matrixOf(settings, stage.rows, lights);
  const bool full = static_cast<Precision>(settings.precision) == Precision::kFull;
  // Where shared memory does not hold a row the scan cannot be had; building by rows and nodes then stands in, as fast
  // as it goes.
  const Scan scan = static_cast<PrefixScheme>(settings.prefix_scheme) == PrefixScheme::kScan
                        ? scanOf(context.device, matrix, !full)
                        : Scan{};
  const bool scanned = scan.lanes > 0;
  builder.roles().scanImpossible |=
      static_cast<PrefixScheme>(settings.prefix_scheme) == PrefixScheme::kScan && !scanned;
  Images images{};
  images.bounds = settings.prefix_bounds != 0
                      ? builder.image("prefix_bounds", TY_FORMAT_RG16_UNORM, stage.slices, stage.rows)
                      : builder.image("prefix_bounds", TY_FORMAT_RG16_UNORM, 1, 1);
  images.levels = builder.image("levels", full ? TY_FORMAT_RGBA32_FLOAT : TY_FORMAT_RGBA16_UNORM,
                                scanned ? matrix.elements() : stage.slices, scanned ? stage.slices : matrix.elements(),
                                matrix.levels * matrix.vectors, true);
  images.ranks = builder.image("ranks", TY_FORMAT_R16_UNORM, stage.slices, (1u << matrix.binBits) + 1);
  addBuild(context, builder, stage, matrix, scan, images);

  const auto evaluate = [&](const char* name, const TyBinding& result, bool first, bool steps) {
    ComputePass pass{
        name,
        "exact_evaluate.comp",
        {uniformAt(0, kFrameBlock), uniformAt(1, kLightBlock), sceneDepthAt(2),
         bufferAt(3, stage.sliceBuffer, TY_ACCESS_STORAGE_READ), shadowMapAt(4), result, sampledAt(6, images.bounds),
         sampledAt(7, stage.rectified), sampledAt(8, stage.projective), sampledAt(9, images.levels),
         sampledAt(10, images.ranks), unshadowedAt21(stage), litAt22(stage), lightCookieAt(23, lights.coloured)},
        groups8(context.structure.width),
        groups8(context.structure.height),
        1,
        kEachLight,
        constantsOf(matrix, settings, scanned)};
    for (const auto& [id, value] :
         {std::pair{5u, static_cast<std::uint32_t>(settings.row_filter)}, {6u, first ? 1u : 0u}, {7u, steps ? 1u : 0u}})
      pass.specializations.push_back({id, value});
    builder.compute(std::move(pass));
  };
  evaluate("evaluate", resultAt5(lights, add), !add, false);

  const std::uint32_t steps =
      builder.image("steps", TY_FORMAT_RGBA32_FLOAT, context.structure.width, context.structure.height);
  evaluate("debug steps", storageAt(5, steps), true, true);
  builder.debugView("steps", "Levels walked by each pixel's ray, both rows together; white = 32", TY_SOURCE_IMAGE,
                    steps, 0, 0, 0.0f, 32.0f);
  for (std::uint32_t level = 0; level < matrix.levels; ++level) {
    const std::string number = std::to_string(level);
    builder.debugView(
        "level_" + number + "_share",
        "Level " + number +
            " of the wavelet matrices: share of a prefix's weight in the nearer half of its node's depths, first "
            "reference ray",
        TY_SOURCE_IMAGE, images.levels, level * matrix.vectors, 1, 0.0f, 1.0f,
        scanned ? TY_VIEW_WALK_LEVEL_ACROSS : TY_VIEW_WALK_LEVEL);
  }
  builder.debugView("ranks", "How many of a slice's depths lie before each depth (downwards); white = all",
                    TY_SOURCE_IMAGE, images.ranks, 0, 0, 0.0f, static_cast<float>(matrix.elements()) / 65535.0f,
                    TY_VIEW_WALK_RANKS);
  if (settings.prefix_bounds != 0) {
    builder.debugView("prefix_min", "Prefix minimum of the depth of the first blocker: rays below it are lit",
                      TY_SOURCE_IMAGE, images.bounds, 0, 0, 0.0f, 1.0f, TY_VIEW_ROWS);
    builder.debugView("prefix_max", "Prefix maximum of the depth of the first blocker: rays above it are shadowed",
                      TY_SOURCE_IMAGE, images.bounds, 0, 1, 0.0f, 1.0f, TY_VIEW_ROWS);
  }
  addRowViews(context, builder, stage);
}

/// The schemes that this device has for the rows of every class of lights.
void addTunable(const LayoutContext& context, LayoutBuilder& builder) {
  const bool full = static_cast<Precision>(context.settings.precision) == Precision::kFull;
  const std::vector<LightClass> classes = lightClasses(context);
  std::vector<double> schemes{static_cast<double>(PrefixScheme::kRow), static_cast<double>(PrefixScheme::kBlock)};
  if (std::all_of(classes.begin(), classes.end(), [&](const LightClass& lights) {
        return scanOf(context.device, matrixOf(context.settings, rowsOf(context.settings, lights), lights), !full)
                   .lanes > 0;
      }))
    schemes.push_back(static_cast<double>(PrefixScheme::kScan));
  if (!classes.empty())
    builder.tunable(prefixSchemeIndex(), static_cast<double>(PrefixScheme::kAuto), schemes, {"build"});
}

void layout(const LayoutContext& context, LayoutBuilder& builder) {
  if (static_cast<RowOrder>(context.settings.row_order) == RowOrder::kDepth) {
    // Strength and visibility of a cookie's columns go together, which counts of blocks do not know: nRMSE 0.040
    // against 0.008 for a sun through a cookie and a roof of bars.
    addRowLayout(context, builder, [](const LayoutContext& c, LayoutBuilder& b, const LightClass& lights, bool add) {
      (lights.coloured ? addClass : addDepthOrder)(c, b, lights, add);
    });
    if (context.sunCookies + context.localCookies > 0)
      addTunable(context, builder);
    else
      addDepthOrderTunable(context, builder);
    return;
  }
  addRowLayout(context, builder, addClass);
  addTunable(context, builder);
}

void prepare(const FrameContext& context) { prepareRectify(context, false); }

constexpr std::array kTechniques = {
    Technique{"exact", "Exact prefix visibility",
              "Walks a wavelet matrix per rectified row: exact on its map, and as many steps whatever the scene.",
              kReads, layout, prepare, true}};

}  // namespace

std::span<const Technique> exactTechniques() { return kTechniques; }

}  // namespace volumetrics
