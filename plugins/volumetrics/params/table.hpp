// All parameters of the plugin as one C++ struct and one ABI table, both expanded from the .params.h rows.
#pragma once

#include <cstdint>
#include <span>

#include "params/common.params.h"
#include "params/rectified.params.h"
#include "techniques/exact/exact.params.h"
#include "techniques/fourier/fourier.params.h"
#include "techniques/moments/moments.params.h"
#include "techniques/ray_march/ray_march.params.h"
#include "tyndall/plugin.h"

#define TY_ALL_PARAMS(INT, FLOAT, ENUM, BOOL) \
  TY_COMMON_PARAMS(INT, FLOAT, ENUM, BOOL)    \
  TY_RAY_MARCH_PARAMS(INT, FLOAT, ENUM, BOOL) \
  TY_RECTIFIED_PARAMS(INT, FLOAT, ENUM, BOOL) \
  TY_MOMENTS_PARAMS(INT, FLOAT, ENUM, BOOL)   \
  TY_FOURIER_PARAMS(INT, FLOAT, ENUM, BOOL)   \
  TY_EXACT_PARAMS(INT, FLOAT, ENUM, BOOL)

namespace volumetrics {

/// Current values. Enums hold the index of the choice.
struct Settings {
  TY_FIELDS(TY_ALL_PARAMS)
};

enum class Overestimation { kLower, kHalf, kUpper, kAdaptive };
enum class Precision { kCompact, kStandard, kFull };
enum class Rectification { kAuto, kLinear, kEpipolar };
enum class RowFilter { kNearest, kLinear, kMipmapped };
enum class PrefixScheme { kAuto, kRow, kBlock, kScan };
enum class RowOrder { kDepth, kColumn };
enum class RowBlocks { k8, k16, k32, k64, kColumns };

/// The ABI table; valid for the library's life. Choices of the technique parameter that no registered technique has
/// (but for "none") are marked as not built.
std::span<const TyParameter> parameterTable();
/// Index of volumetrics.technique and volumetrics.prefix_scheme in the table.
std::uint32_t techniqueIndex();
std::uint32_t prefixSchemeIndex();

/// Values in table order (TyStructure.values, TyFrame.values) as a struct; missing ones keep their defaults.
Settings readSettings(const double* values, std::uint32_t count);

}  // namespace volumetrics
