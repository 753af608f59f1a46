// What a layout depends on, and the engine's frame in the ABI's words.
#pragma once

#include <string>
#include <vector>

#include "gpu/device.hpp"
#include "host/layout.hpp"
#include "params/params.hpp"
#include "render/frame.hpp"

namespace tyndall::host {

/// Owns what a TyStructure points to.
struct Structure {
  std::uint32_t width = 1, height = 1;
  std::vector<std::uint32_t> lightKinds, shadowSizes;
  std::uint32_t shadowMoments = TY_FORMAT_UNKNOWN;  ///< TyFormat
  std::vector<std::uint32_t> lightCookies;          ///< faces of each light's
  bool cookies = false;                             ///< the renderer offers them
  std::vector<double> values;                       ///< of every parameter
  std::vector<bool> structural;

  TyStructure abi() const;  ///< points into this
  LayoutContext context() const {
    return {width, height, lightKinds, static_cast<std::uint32_t>(values.size()), structural, shadowMoments, cookies};
  }
  /// The same layout is due: equal but for values that are not structural.
  bool sameLayout(const Structure& other) const;
  /// The same but for the parameters: picture, lights and what the renderer offers.
  bool sameSurroundings(const Structure& other) const;
};
Structure makeStructure(const render::EffectInput& input, const std::vector<params::Parameter>& parameters,
                        const params::Table& table);

TyDevice makeDevice(const gpu::DeviceInfo& info);
LayoutLimits makeLimits(const gpu::DeviceInfo& info);

TyView makeView(const render::View& view);
TyLight makeLight(const render::ShadowedLight& light);
std::uint32_t lightKind(scene::LightKind kind);  ///< TyLightKind

}  // namespace tyndall::host
