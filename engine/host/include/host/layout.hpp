// A plugin's layout as the host keeps it: copied, then checked before anything is made of it. Needs no GPU, so plugins
// test their layouts with it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "host/abi.hpp"

namespace tyndall::host {

// The copies keep the ABI's structs for their numbers; pointers in them are null, texts and arrays stand beside them.
struct LayoutImage {
  std::string name;
  TyImage d;
};
struct LayoutBuffer {
  std::string name;
  TyBuffer d;
};
struct LayoutUniform {
  std::string name;
  TyUniformBlock d;
};
struct LayoutPass {
  std::string name, shader;
  TyPass d;
  std::vector<TyBinding> bindings;
  std::vector<TySpecialization> specializations;
  std::vector<TyTarget> targets;
  std::optional<TyTarget> depthTarget;
};
struct LayoutDebugView {
  std::string name, doc;
  TyDebugView d;
};
struct LayoutCounters {
  std::uint32_t buffer = 0;
  std::vector<std::string> names;
};
struct LayoutTunable {
  std::uint32_t parameter = 0;
  double automatic = 0;
  std::vector<double> variants;
  std::vector<std::string> passes;
};

struct Layout {
  std::vector<LayoutImage> images;
  std::vector<LayoutBuffer> buffers;
  std::vector<LayoutUniform> uniforms;
  std::vector<LayoutPass> passes;
  std::vector<LayoutDebugView> debugViews;
  std::optional<LayoutCounters> counters;
  std::vector<LayoutTunable> tunables;
};

/// Copies every array and string. Errors: a null array with a count, sizes that cannot be, missing or endless strings.
Result<Layout> copyLayout(const TyLayout* layout);

/// What a layout may ask of the device, beyond TyDevice.
struct LayoutLimits {
  std::uint32_t image2d = 16384, image3d = 2048, layers = 2048, pushDescriptors = 32, colorTargets = 8;
  std::array<std::uint32_t, 3> groups = {65535, 65535, 65535};
  std::uint64_t storageBuffer = 128ull << 20;
};

/// What the checks need to know of the structure the layout was made for.
struct LayoutContext {
  std::uint32_t width = 1, height = 1;
  std::vector<std::uint32_t> lightKinds;
  std::uint32_t valueCount = 0;
  std::vector<bool> structural;                     ///< of each parameter
  std::uint32_t shadowMoments = TY_FORMAT_UNKNOWN;  ///< TyFormat of the lights' moment shadow maps
  bool cookies = false;                             ///< the renderer offers the lights' cookies
};

/// Every rule of the ABI that can be checked without a GPU; the first broken one is the error ("pass 'march': ...").
Result<void> checkLayout(const Layout& layout, const LayoutLimits& limits, const LayoutContext& context);

/// One pass as it is run: per-light groups are expanded light by light.
struct PassRun {
  std::uint32_t pass = 0;         ///< index into Layout::passes
  std::uint32_t light = TY_NONE;  ///< of a per-light pass
};
std::vector<PassRun> expandPasses(const Layout& layout, const std::vector<std::uint32_t>& lightKinds);

/// A resource of a layout, or the output (source TY_SOURCE_OUTPUT, index 0).
struct LayoutResource {
  std::uint32_t source = TY_SOURCE_IMAGE, index = 0;
  bool operator==(const LayoutResource&) const = default;
};

/// How one pass uses one resource, all its bindings and targets taken together.
enum class PassAccess {
  kSampled,
  kStorageRead,
  kStorageWrite,
  kStorageReadWrite,
  kSampledStorage,  ///< images: sampled here, stored to there
  kColorWrite,
  kColorReadWrite,
  kDepthWrite,
  kDepthReadWrite,
  kIndirect
};
struct PassUse {
  LayoutResource resource;
  PassAccess access;
};
/// An error if the pass uses a resource in two ways that exclude each other: parts of an image that are written and
/// parts of it that are used otherwise must not touch. Uniform blocks are left out.
Result<std::vector<PassUse>> usesOf(const Layout& layout, const LayoutPass& pass);

bool readsOld(PassAccess access);  ///< needs what earlier passes wrote
bool writesTo(PassAccess access);

inline bool isHistory(const LayoutImage& image) { return (image.d.flags & TY_RESOURCE_HISTORY) != 0; }
inline bool isHistory(const LayoutBuffer& buffer) { return (buffer.d.flags & TY_RESOURCE_HISTORY) != 0; }
bool isInteger(std::uint32_t format);             ///< a *_UINT format
std::uint32_t formatBytes(std::uint32_t format);  ///< of one texel; 0 for an unknown format
std::uint64_t imageBytes(const TyImage& image);   ///< of all mips and layers, tightly packed
/// Bytes that one run of a pass moves if every part of the layout's images and buffers, and of an output of
/// `outputBytes`, that it is bound to is read once, written once, or both; what is the engine's does not count.
std::uint64_t bytesMoved(const Layout& layout, const LayoutPass& pass, std::uint64_t outputBytes);

}  // namespace tyndall::host
