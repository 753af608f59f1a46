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

/// What prepare() gets, with the values already read.
struct FrameContext {
  const TyFrame& frame;
  const TyUniformData& out;
  Settings settings;
  /// Block `block` of light `light` (0 for a per-frame block).
  template <class T>
  T& block(std::uint32_t index, std::uint32_t light = 0) const {
    return *reinterpret_cast<T*>(out.data[index] + static_cast<std::size_t>(light) * out.stride[index]);
  }
};

struct LayoutContext {
  const TyDevice& device;
  const TyStructure& structure;
  Settings settings;
  std::uint32_t directionalLights = 0;
};

struct Technique {
  const char* id;
  const char* name;
  const char* doc;
  std::span<const char* const> reads;
  void (*layout)(const LayoutContext& context, LayoutBuilder& builder);
  void (*prepare)(const FrameContext& context);
};

}  // namespace volumetrics
