// Collects a layout and owns what its C structs point to.
#pragma once

#include <cstdint>
#include <deque>
#include <initializer_list>
#include <string>
#include <vector>

#include "technique.hpp"
#include "tyndall/plugin.h"

namespace volumetrics {

/// Shorthands for a pass's bindings.
TyBinding uniformAt(std::uint32_t binding, std::uint32_t block);
TyBinding sceneDepthAt(std::uint32_t binding);
TyBinding shadowMapAt(std::uint32_t binding);
TyBinding shadowMomentsAt(std::uint32_t binding);
/// The light's cookie, or, where no light has one, its shadow map, which a specialization then never reads.
TyBinding lightCookieAt(std::uint32_t binding, bool cookies);
TyBinding outputAt(std::uint32_t binding, TyAccess access);
TyBinding sampledAt(std::uint32_t binding, std::uint32_t image, TySampler sampler = TY_SAMPLER_NEAREST_CLAMP);
TyBinding storageAt(std::uint32_t binding, std::uint32_t image, TyAccess access = TY_ACCESS_STORAGE_WRITE);
TyBinding bufferAt(std::uint32_t binding, std::uint32_t buffer, TyAccess access);
/// The same binding for one mip of its image.
TyBinding mipOf(TyBinding binding, std::uint32_t mip);

/// Kinds of light that a pass runs for, as bits of TyLightKind.
constexpr std::uint32_t kSuns = 1u << TY_LIGHT_DIRECTIONAL, kLocalLights = 1u << TY_LIGHT_SPOT | 1u << TY_LIGHT_POINT;
/// Stands for the kinds last given to LayoutBuilder::lights().
constexpr std::uint32_t kEachLight = 1u << 31;

struct ComputePass {
  std::string name;
  const char* shader;
  std::vector<TyBinding> bindings;
  std::uint32_t groupsX = 1, groupsY = 1, groupsZ = 1;
  std::uint32_t lightKinds = 0;  ///< run once for each light of these kinds; 0: once
  std::vector<TySpecialization> specializations;
};

class LayoutBuilder {
 public:
  void clear();
  /// Images, buffers and debug views of a name that is there already, and of the same shape, are shared: lights of all
  /// kinds take turns in them. An image of another shape gets a name of its own.
  std::uint32_t image(const char* name, TyFormat format, std::uint32_t width, std::uint32_t height,
                      std::uint32_t layers = 1, bool array = false, std::uint32_t mips = 1);
  std::uint32_t mipsOf(std::uint32_t image) const { return images_[image].mips; }
  std::uint32_t layersOf(std::uint32_t image) const { return images_[image].depth; }
  std::uint32_t buffer(const char* name, std::uint64_t bytes);
  std::uint32_t uniform(std::string name, std::uint32_t bytes, bool perLight);
  /// Kinds of light that passes for kEachLight run for from here on, those with a cookie or those without:
  /// LayoutRoles::classes keeps which.
  void lights(std::uint32_t kinds, bool cookie, bool fading = false) {
    roles_.classes.push_back({kinds, cookie, fading, {}});
  }
  /// Compute passes from here on that bind uniform block `from` get block `to` instead; the same twice: as they were.
  void substituteUniform(std::uint32_t from, std::uint32_t to) { substituted_ = from, substitute_ = to; }
  /// Specialization constants that every compute pass from here on gets besides its own.
  void specializeAll(std::vector<TySpecialization> constants) { common_ = std::move(constants); }
  /// Returns the pass's index.
  std::uint32_t compute(ComputePass pass);
  /// Rasterises the casters of every directional light, by the matrix at the start of `uniformBlock`, into one layer of
  /// a D32 image: cleared to 1, nearer kept. Returns the pass's index.
  std::uint32_t casters(std::string name, std::uint32_t image, std::uint32_t layer, std::uint32_t uniformBlock);
  void debugView(std::string name, std::string doc, TySource source, std::uint32_t index, std::uint32_t layer,
                 std::uint32_t channel, float low, float high, TyViewRole role = TY_VIEW_PLAIN);
  void tunable(std::uint32_t parameter, double automatic, std::vector<double> variants,
               std::vector<const char*> passes);
  LayoutRoles& roles() { return roles_; }
  /// Valid until the next clear().
  const TyLayout& finish();

 private:
  std::vector<TyImage> images_;
  std::vector<TyBuffer> buffers_;
  std::vector<TyUniformBlock> uniforms_;
  std::vector<TyPass> passes_;
  std::deque<ComputePass> passData_;  // a deque: its elements stay in place
  std::vector<TyDebugView> views_;
  std::vector<TyTunable> tunables_;
  std::deque<std::vector<double>> variants_;
  std::deque<std::vector<const char*>> passNames_;
  std::deque<std::string> names_;
  std::deque<TyTarget> targets_;
  std::vector<TySpecialization> common_;
  std::uint32_t substituted_ = TY_NONE, substitute_ = TY_NONE;
  LayoutRoles roles_;
  TyLayout layout_{};
};

}  // namespace volumetrics
