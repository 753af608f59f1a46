// What passes do to resources, and the order in which they run.
#include <algorithm>
#include <map>

#include "host/layout.hpp"

namespace tyndall::host {
namespace {

Result<void> join(std::vector<PassUse>& uses, LayoutResource resource, PassAccess access, const LayoutPass& pass) {
  const auto same =
      std::find_if(uses.begin(), uses.end(), [&](const PassUse& use) { return use.resource == resource; });
  if (same == uses.end()) {
    uses.push_back({resource, access});
    return {};
  }
  // Barriers are for whole resources: one state per pass. Several reads of the same kind are one state.
  if (same->access == access && (!writesTo(access) || access == PassAccess::kStorageReadWrite)) return {};
  const char* const kinds[] = {"image",      "buffer", "uniform block",     "scene depth",
                               "shadow map", "output", "moment shadow map", "light's cookie"};
  return failed("pass '" + pass.name + "': uses " + kinds[resource.source] + " " + std::to_string(resource.index) +
                " in two ways at once; use it one way, or split the pass");
}

PassAccess accessOf(const TyBinding& binding) {
  switch (binding.access) {
    case TY_ACCESS_STORAGE_READ: return PassAccess::kStorageRead;
    case TY_ACCESS_STORAGE_WRITE: return PassAccess::kStorageWrite;
    case TY_ACCESS_STORAGE_READ_WRITE: return PassAccess::kStorageReadWrite;
    default: return PassAccess::kSampled;
  }
}

std::uint32_t layersOf(const TyImage& image) { return image.kind == TY_IMAGE_2D_ARRAY ? image.depth : 1; }

/// What a binding reaches of its image, half-open.
struct Part {
  std::uint32_t firstMip, endMip, firstLayer, endLayer;
  bool touches(const Part& o) const {
    return firstMip < o.endMip && o.firstMip < endMip && firstLayer < o.endLayer && o.firstLayer < endLayer;
  }
};
Part partOf(const TyImage& image, const TyBinding& b) {
  const std::uint32_t layers = layersOf(image);
  const std::uint32_t mips = b.access != TY_ACCESS_SAMPLED ? 1 : b.mip_count;
  return {b.base_mip, mips ? b.base_mip + mips : image.mips, b.base_layer,
          b.layer_count ? b.base_layer + b.layer_count : layers};
}

/// All bindings of one image together. Mixed uses are one state if what is written is used by no other binding.
Result<PassAccess> imageAccess(const Layout& layout, const LayoutPass& pass, std::uint32_t index) {
  const TyImage& image = layout.images[index].d;
  std::vector<const TyBinding*> bindings;
  for (const TyBinding& b : pass.bindings)
    if (b.source == TY_SOURCE_IMAGE && b.index == index) bindings.push_back(&b);
  const PassAccess first = accessOf(*bindings.front());
  bool sampled = false, mixed = false;
  for (const TyBinding* b : bindings) sampled |= accessOf(*b) == PassAccess::kSampled, mixed |= accessOf(*b) != first;
  if (!mixed && (!writesTo(first) || first == PassAccess::kStorageReadWrite)) return first;
  for (std::size_t i = 0; i < bindings.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const TyBinding &a = *bindings[k], &b = *bindings[i];
      const bool same = a.access == b.access && a.access != TY_ACCESS_STORAGE_WRITE;
      const bool written = writesTo(accessOf(a)) || writesTo(accessOf(b));
      if (!same && (!written || partOf(image, a).touches(partOf(image, b))))
        return failed("pass '" + pass.name + "': bindings " + std::to_string(a.binding) + " and " +
                      std::to_string(b.binding) + " use image '" + layout.images[index].name + "' in two ways at once" +
                      (written ? " and their mips and layers overlap; keep what is written apart (base_mip, mip_count, "
                                 "base_layer, layer_count), or split the pass"
                               : "; read it one way, or split the pass"));
    }
  if (sampled) return PassAccess::kSampledStorage;
  return mixed ? PassAccess::kStorageReadWrite : first;
}

}  // namespace

Result<std::vector<PassUse>> usesOf(const Layout& layout, const LayoutPass& pass) {
  std::vector<PassUse> uses;
  for (const TyBinding& binding : pass.bindings) {
    if (binding.source == TY_SOURCE_UNIFORM) continue;
    if (binding.source == TY_SOURCE_IMAGE) {
      const LayoutResource image{TY_SOURCE_IMAGE, binding.index};
      if (std::any_of(uses.begin(), uses.end(), [&](const PassUse& use) { return use.resource == image; })) continue;
      const auto access = imageAccess(layout, pass, binding.index);
      if (!access) return access.error();
      uses.push_back({image, *access});
      continue;
    }
    if (auto r = join(uses, {binding.source, binding.index}, accessOf(binding), pass); !r) return r.error();
  }
  for (const TyTarget& target : pass.targets)
    if (auto r = join(uses, {target.source, target.index},
                      target.load ? PassAccess::kColorReadWrite : PassAccess::kColorWrite, pass);
        !r)
      return r.error();
  if (pass.depthTarget) {
    const TyTarget& target = *pass.depthTarget;
    if (auto r = join(uses, {target.source, target.index},
                      target.load ? PassAccess::kDepthReadWrite : PassAccess::kDepthWrite, pass);
        !r)
      return r.error();
  }
  if (pass.d.kind == TY_PASS_COMPUTE_INDIRECT)
    if (auto r = join(uses, {TY_SOURCE_BUFFER, pass.d.indirect_buffer}, PassAccess::kIndirect, pass); !r)
      return r.error();
  return uses;
}

bool readsOld(PassAccess access) {
  return access != PassAccess::kStorageWrite && access != PassAccess::kColorWrite && access != PassAccess::kDepthWrite;
}

bool writesTo(PassAccess access) {
  return access != PassAccess::kSampled && access != PassAccess::kStorageRead && access != PassAccess::kIndirect;
}

std::vector<PassRun> expandPasses(const Layout& layout, const std::vector<std::uint32_t>& lightKinds) {
  std::vector<PassRun> runs;
  const auto count = static_cast<std::uint32_t>(layout.passes.size());
  for (std::uint32_t first = 0; first < count;) {
    if (!layout.passes[first].d.per_light) {
      runs.push_back({first++, TY_NONE});
      continue;
    }
    std::uint32_t end = first;
    while (end < count && layout.passes[end].d.per_light) ++end;
    for (std::uint32_t light = 0; light < lightKinds.size(); ++light)
      for (std::uint32_t p = first; p < end; ++p) {
        const std::uint32_t kinds = layout.passes[p].d.light_kinds;
        if (kinds == 0 || (kinds >> lightKinds[light] & 1) != 0) runs.push_back({p, light});
      }
    first = end;
  }
  return runs;
}

bool isInteger(std::uint32_t format) { return format >= TY_FORMAT_R32_UINT && format <= TY_FORMAT_RGBA32_UINT; }

std::uint32_t formatBytes(std::uint32_t format) {
  switch (format) {
    case TY_FORMAT_R8_UNORM: return 1;
    case TY_FORMAT_R16_UNORM:
    case TY_FORMAT_R16_FLOAT: return 2;
    case TY_FORMAT_RGBA8_UNORM:
    case TY_FORMAT_A2B10G10R10_UNORM:
    case TY_FORMAT_RG16_UNORM:
    case TY_FORMAT_RG16_FLOAT:
    case TY_FORMAT_R32_FLOAT:
    case TY_FORMAT_R32_UINT:
    case TY_FORMAT_D32_FLOAT: return 4;
    case TY_FORMAT_RGBA16_UNORM:
    case TY_FORMAT_RGBA16_FLOAT:
    case TY_FORMAT_RG32_FLOAT:
    case TY_FORMAT_RG32_UINT: return 8;
    case TY_FORMAT_RGBA32_FLOAT:
    case TY_FORMAT_RGBA32_UINT: return 16;
    default: return 0;
  }
}

namespace {

/// Of one mip: a layer of an array, all of a 3D image.
std::uint64_t layerBytes(const TyImage& image, std::uint32_t mip) {
  const auto side = [mip](std::uint32_t size) { return std::uint64_t{std::max(1u, size >> mip)}; };
  return side(image.width) * side(image.height) * (image.kind == TY_IMAGE_3D ? side(image.depth) : 1) *
         formatBytes(image.format);
}

}  // namespace

std::uint64_t imageBytes(const TyImage& image) {
  std::uint64_t bytes = 0;
  for (std::uint32_t mip = 0; mip < image.mips; ++mip) bytes += layerBytes(image, mip) * layersOf(image);
  return bytes;
}

std::uint64_t bytesMoved(const Layout& layout, const LayoutPass& pass, std::uint64_t outputBytes) {
  // Every part once in each direction, however many bindings reach it: (source, index, mip, layer, written) -> bytes.
  std::map<std::array<std::uint32_t, 5>, std::uint64_t> parts;
  const auto add = [&](std::uint32_t source, std::uint32_t index, const Part& part, PassAccess access) {
    for (const bool written : {false, true}) {
      if (!(written ? writesTo(access) : readsOld(access))) continue;
      if (source == TY_SOURCE_BUFFER) parts[{source, index, 0, 0, written}] = layout.buffers[index].d.size;
      if (source == TY_SOURCE_OUTPUT) parts[{source, index, 0, 0, written}] = outputBytes;
      if (source != TY_SOURCE_IMAGE) continue;
      for (std::uint32_t mip = part.firstMip; mip < part.endMip; ++mip)
        for (std::uint32_t layer = part.firstLayer; layer < part.endLayer; ++layer)
          parts[{source, index, mip, layer, written}] = layerBytes(layout.images[index].d, mip);
    }
  };
  for (const TyBinding& b : pass.bindings)
    add(b.source, b.index, b.source == TY_SOURCE_IMAGE ? partOf(layout.images[b.index].d, b) : Part{}, accessOf(b));
  const auto addTarget = [&](const TyTarget& t, PassAccess loaded, PassAccess fresh) {
    add(t.source, t.index, {t.mip, t.mip + 1, t.layer, t.layer + 1}, t.load ? loaded : fresh);
  };
  for (const TyTarget& target : pass.targets) addTarget(target, PassAccess::kColorReadWrite, PassAccess::kColorWrite);
  if (pass.depthTarget) addTarget(*pass.depthTarget, PassAccess::kDepthReadWrite, PassAccess::kDepthWrite);
  std::uint64_t bytes = 0;
  for (const auto& [part, size] : parts) bytes += size;
  return bytes;
}

}  // namespace tyndall::host
