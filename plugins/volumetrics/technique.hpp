// What a technique is: a name, the parameters it reads, a pure layout and a prepare. Each technique folder defines
// `std::span<const Technique> <folder>Techniques()`; the registry is generated from the folder names.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "params/table.hpp"
#include "tyndall/plugin.h"

namespace volumetrics {

/// A layout under construction, which owns every array that the ABI struct points to.
class LayoutBuilder;

/// Passes that serve one class of lights (stages/rectify.hpp): prepare() leaves them out for the others of their kinds.
struct ClassPasses {
  std::uint32_t kinds = 0;  ///< bits of TyLightKind
  bool cookie = false;      ///< of lights with a cookie, or of those without
  bool fading = false;      ///< for the second map of a sun whose rectification changes
  std::vector<std::uint32_t> passes;
};

/// Passes and blocks that make a sun's rectified map.
struct MapPasses {
  std::uint32_t rectifyPass = TY_NONE;  ///< resampling, skipped in frames with a projective map
  std::uint32_t casterPass = TY_NONE;   ///< first of the passes that rasterise projective maps, skipped in other frames
  std::uint32_t casterBlock = TY_NONE;  ///< first of their uniform blocks, one mat4 each
  std::uint32_t splits = 0;             ///< how many of both
};

/// Passes and blocks of a layout that prepare() must find again.
struct LayoutRoles {
  MapPasses map, fadingMap;
  std::vector<ClassPasses> classes;
  std::vector<std::uint32_t> localPasses;  ///< those that run for spot or point lights
  /// Of those in a class, all that do not write the result: needless for a lamp that is marched.
  std::vector<std::uint32_t> localRowPasses;
  std::uint32_t standInClear =
      TY_NONE;  ///< clears the result in frames in which the only light, a local one, reaches no view ray
  bool momentsMissing = false;  ///< filtered resampling was asked for, but the host makes no moment shadow maps
  bool scanImpossible = false;  ///< a workgroup scan was asked for, but shared memory does not hold a row
};

/// What a prepare() has to tell people, once.
struct FrameReport {
  bool linearImpossible = false;  ///< rectification=linear, but no projective map exists for this view
  bool linearHandsOver = false;   ///< rectification=linear, but its map is near its singularity
  bool linearCookie = false;      ///< rectification=linear, but a sun has a cookie
};

/// What prepare() gets, with the values already read.
struct FrameContext {
  const TyFrame& frame;
  const TyUniformData& out;
  Settings settings;
  LayoutRoles roles;
  FrameReport& report;
  /// Block `block` of light `light` (0 for a per-frame block).
  template <class T>
  T& block(std::uint32_t index, std::uint32_t light = 0) const {
    return *reinterpret_cast<T*>(out.data[index] + static_cast<std::size_t>(light) * out.stride[index]);
  }
  /// Leaves a pass of one light out of this frame.
  void skip(std::uint32_t pass, std::uint32_t light) const {
    // A host of version 1.0 hands in a shorter struct.
    if (out.struct_size >= sizeof(TyUniformData) && out.skip != nullptr) out.skip[pass * out.skip_stride + light] = 1;
  }
};

struct LayoutContext {
  const TyDevice& device;
  const TyStructure& structure;
  Settings settings;
  std::uint32_t directionalLights = 0;
  std::uint32_t localLights() const { return structure.light_count - directionalLights; }  ///< spot and point lights
  std::uint32_t shadowMoments = TY_FORMAT_UNKNOWN;  ///< TyFormat of the host's moment shadow maps
  std::uint32_t sunCookies = 0, localCookies = 0;   ///< suns, and spot or point lights, that have a cookie
};

struct Technique {
  const char* id;
  const char* name;
  const char* doc;
  std::span<const char* const> reads;
  void (*layout)(const LayoutContext& context, LayoutBuilder& builder);
  void (*prepare)(const FrameContext& context);
  bool localLights = false;  ///< spot and point lights scatter too
};

}  // namespace volumetrics
