// One pass: its kind, shader, bindings and targets.
#include "layout_check_pass.hpp"

#include <cmath>
#include <set>

namespace tyndall::host {
namespace {

using Text = std::string;
Text str(std::uint64_t number) { return std::to_string(number); }

class PassChecker {
 public:
  PassChecker(const Layout& layout, const LayoutLimits& limits, const LayoutContext& context)
      : l_(layout), limits_(limits), context_(context) {}

  Result<void> pass(const LayoutPass& p) {
    const auto bad = [&](const Text& what) { return failed("pass '" + p.name + "': " + what); };
    const TyPass& d = p.d;
    if (d.kind == TY_PASS_SHADOW_VOLUMES)
      return bad("shadow volumes are not built yet (ability 'tyndall.shadow_volumes')");
    if (d.kind > TY_PASS_SHADOW_VOLUMES) return bad("kind " + str(d.kind) + " is unknown; kinds are 0 to 4");
    if (d.per_light > 1 || d.light_kinds > 7) return bad("per_light is 0 or 1, light_kinds a mask of bits 0 to 2");
    const bool compute = d.kind == TY_PASS_COMPUTE || d.kind == TY_PASS_COMPUTE_INDIRECT;
    if (auto r = shader(p, d.kind == TY_PASS_CASTERS ? "" : compute ? ".comp" : ".frag"); !r) return r;
    if (p.bindings.size() > limits_.pushDescriptors)
      return bad("has " + str(p.bindings.size()) + " bindings; the device takes " + str(limits_.pushDescriptors));
    std::set<std::uint32_t> numbers, ids;
    for (const TyBinding& b : p.bindings) {
      if (!numbers.insert(b.binding).second) return bad("binding " + str(b.binding) + " is given twice");
      if (auto r = binding(p, b, compute); !r) return bad("binding " + str(b.binding) + " " + r.error().message);
    }
    for (const TySpecialization& s : p.specializations)
      if (!ids.insert(s.id).second) return bad("specialization constant " + str(s.id) + " is given twice");
    if (compute && (!p.targets.empty() || p.depthTarget))
      return bad("is a compute pass with targets; only full-screen and caster passes have them");
    if (d.kind == TY_PASS_COMPUTE)
      for (int axis = 0; axis < 3; ++axis)
        if (d.groups[axis] < 1 || d.groups[axis] > limits_.groups[static_cast<std::size_t>(axis)])
          return bad("groups[" + str(static_cast<std::uint64_t>(axis)) + "] is " + str(d.groups[axis]) + "; 1 to " +
                     str(limits_.groups[static_cast<std::size_t>(axis)]));
    if (d.kind == TY_PASS_COMPUTE_INDIRECT) {
      if (d.indirect_buffer >= l_.buffers.size())
        return bad("indirect buffer " + str(d.indirect_buffer) + " is out of range; there are " +
                   str(l_.buffers.size()));
      const std::uint64_t size = l_.buffers[d.indirect_buffer].d.size;
      if (d.indirect_offset % 4 != 0 || size < 12 || d.indirect_offset > size - 12)
        return bad("indirect_offset " + str(d.indirect_offset) + " leaves no three aligned counts in " + str(size) +
                   " bytes");
    }
    if (!compute)
      if (auto r = targets(p); !r) return bad(r.error().message);
    if (d.kind == TY_PASS_CASTERS)
      if (auto r = casters(p); !r) return bad(r.error().message);
    if (auto uses = usesOf(l_, p); !uses) return uses.error();
    return {};
  }

 private:
  Result<void> shader(const LayoutPass& p, const Text& ending) {
    if (ending.empty()) return {};
    bool plain =
        p.shader.size() > ending.size() && p.shader.size() <= 128 && p.shader.ends_with(ending) && p.shader[0] != '.';
    for (const char c : p.shader)
      plain = plain && (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-');
    if (!plain)
      return failed("pass '" + p.name + "': shader '" + p.shader + "' is no plain file name ending in " + ending);
    return {};
  }

  Result<void> binding(const LayoutPass& p, const TyBinding& b, bool compute) {
    const auto limit = [&](std::size_t count, const char* what) -> Result<void> {
      if (b.index < count) return {};
      return failed(Text("refers to ") + what + " " + str(b.index) + "; there are " + str(count));
    };
    if (b.access > TY_ACCESS_UNIFORM) return failed("has unknown access " + str(b.access));
    if ((b.access == TY_ACCESS_UNIFORM) != (b.source == TY_SOURCE_UNIFORM))
      return failed("mixes uniform access with another source, or the reverse");
    const bool storage = b.access != TY_ACCESS_SAMPLED && b.access != TY_ACCESS_UNIFORM;
    if (storage && !compute && !(b.source == TY_SOURCE_BUFFER && b.access == TY_ACCESS_STORAGE_READ))
      return failed("stores or loads an image by storage access, or writes a buffer; only compute passes do");
    std::uint32_t format = TY_FORMAT_D32_FLOAT, mips = 1, layers = 1;
    switch (b.source) {
      case TY_SOURCE_UNIFORM:
        if (auto r = limit(l_.uniforms.size(), "uniform block"); !r) return r;
        if (l_.uniforms[b.index].d.per_light && !p.d.per_light)
          return failed("takes a per-light uniform block in a pass that is not per light");
        return {};
      case TY_SOURCE_BUFFER:
        if (auto r = limit(l_.buffers.size(), "buffer"); !r) return r;
        return storage ? Result<void>{} : failed("samples a buffer; buffers have storage access");
      case TY_SOURCE_IMAGE: {
        if (auto r = limit(l_.images.size(), "image"); !r) return r;
        const TyImage& image = l_.images[b.index].d;
        format = image.format;
        mips = image.mips;
        layers = image.kind == TY_IMAGE_2D_ARRAY ? image.depth : 1;
        break;
      }
      case TY_SOURCE_OUTPUT: format = TY_FORMAT_RGBA32_FLOAT; break;
      case TY_SOURCE_SHADOW_MOMENTS:
        if (context_.shadowMoments == TY_FORMAT_UNKNOWN)
          return failed("takes a moment shadow map, which this renderer does not make (shadow_moments_format)");
        if (b.access != TY_ACCESS_SAMPLED) return failed("stores to or loads from a moment shadow map; sample it");
        if (b.base_mip != 0 || b.mip_count != 0)
          return failed("takes some mips of a moment shadow map; bind all of it");
        format = context_.shadowMoments;
        [[fallthrough]];
      case TY_SOURCE_SHADOW_MAP:
        if (!p.d.per_light) return failed("takes a shadow map in a pass that is not per light");
        layers = TY_NONE;  // 1 or 6, by the light: only the whole array can be bound
        if (b.base_layer != 0 || b.layer_count != 0) return failed("takes a part of a shadow map; bind all of it");
        break;
      case TY_SOURCE_LIGHT_COOKIE:
        if (!context_.cookies)
          return failed("takes a light's cookie, which this renderer does not offer (light_cookies)");
        if (!p.d.per_light) return failed("takes a light's cookie in a pass that is not per light");
        if (b.access != TY_ACCESS_SAMPLED) return failed("stores to or loads from a light's cookie; sample it");
        if (b.base_mip != 0 || b.mip_count != 0 || b.base_layer != 0 || b.layer_count != 0)
          return failed("takes a part of a light's cookie; bind all of it");
        format = TY_FORMAT_RGBA16_FLOAT;
        break;
      case TY_SOURCE_SCENE_DEPTH: break;
      default: return failed("has unknown source " + str(b.source));
    }
    if (b.source != TY_SOURCE_IMAGE && b.index != 0)
      return failed("has index " + str(b.index) + "; this source has only index 0");
    if (storage && format == TY_FORMAT_D32_FLOAT) return failed("stores to or loads from a depth image; sample it");
    if (b.base_mip >= mips || b.mip_count > mips - b.base_mip)
      return failed("takes mips beyond the image's " + str(mips));
    if (b.base_layer >= layers || b.layer_count > layers - b.base_layer)
      return failed("takes layers beyond the image's " + str(layers));
    if (storage && b.mip_count > 1) return failed("takes several mips by storage access; bind one");
    if (b.access == TY_ACCESS_SAMPLED) {
      if (b.sampler > TY_SAMPLER_LINEAR_MIPMAP_REPEAT) return failed("has unknown sampler " + str(b.sampler));
      const bool nearest = b.sampler == TY_SAMPLER_NEAREST_CLAMP || b.sampler == TY_SAMPLER_NEAREST_REPEAT;
      if (!nearest && (format == TY_FORMAT_D32_FLOAT || isInteger(format)))
        return failed("filters a depth or integer format linearly; take a nearest sampler");
    }
    return {};
  }

  Result<void> targets(const LayoutPass& p) {
    if (p.targets.empty() && !p.depthTarget) return failed("draws to no target; give one");
    if (p.targets.size() > limits_.colorTargets)
      return failed("has " + str(p.targets.size()) + " targets; at most " + str(limits_.colorTargets));
    std::uint32_t width = 0, height = 0;
    const auto one = [&](const TyTarget& t, bool depth) -> Result<void> {
      TyImage image{};
      image.format = TY_FORMAT_RGBA32_FLOAT;
      image.width = context_.width;
      image.height = context_.height;
      image.depth = image.mips = 1;
      if (t.source == TY_SOURCE_IMAGE) {
        if (t.index >= l_.images.size())
          return failed("target image " + str(t.index) + " is out of range; there are " + str(l_.images.size()));
        image = l_.images[t.index].d;
      } else if (t.source != TY_SOURCE_OUTPUT || t.index != 0) {
        return failed("a target is neither an image nor the output");
      }
      if (image.kind == TY_IMAGE_3D) return failed("draws to a 3D image; store to it from a compute pass");
      if ((image.format == TY_FORMAT_D32_FLOAT) != depth)
        return failed(depth ? "the depth target is no depth image" : "a colour target is a depth image");
      if (t.mip >= image.mips || t.layer >= image.depth) return failed("a target's mip or layer is out of range");
      if (t.load > 1 || t.blend > TY_BLEND_MAX) return failed("a target's load is 0 or 1, its blend 0 to 3");
      if (!depth && t.blend != TY_BLEND_NONE && isInteger(image.format)) return failed("blends into an integer format");
      for (const float c : t.clear)
        if (!std::isfinite(c)) return failed("a target's clear value is not finite");
      if (depth && !(t.clear[0] >= 0 && t.clear[0] <= 1))
        return failed("the depth target's clear value is outside [0, 1]");
      const std::uint32_t w = std::max(1u, image.width >> t.mip), h = std::max(1u, image.height >> t.mip);
      if (width != 0 && (w != width || h != height)) return failed("its targets differ in size");
      width = w;
      height = h;
      return {};
    };
    for (const TyTarget& t : p.targets)
      if (auto r = one(t, false); !r) return r;
    if (p.depthTarget)
      if (auto r = one(*p.depthTarget, true); !r) return r;
    return p.d.depth_compare > 2 ? failed("depth_compare is 0 to 2") : Result<void>{};
  }

  Result<void> casters(const LayoutPass& p) {
    if (!p.depthTarget || !p.targets.empty() || !p.bindings.empty())
      return failed("a caster pass draws depth only: one depth target, no colour target, no binding");
    if (p.d.caster_uniform >= l_.uniforms.size())
      return failed("caster_uniform " + str(p.d.caster_uniform) + " is out of range");
    const TyUniformBlock& block = l_.uniforms[p.d.caster_uniform].d;
    if (block.size < 64 || (block.per_light && !p.d.per_light))
      return failed("caster_uniform is no block that starts with a mat4 for this pass");
    return {};
  }

  const Layout& l_;
  const LayoutLimits& limits_;
  const LayoutContext& context_;
};

}  // namespace

Result<void> checkPass(const Layout& layout, const LayoutLimits& limits, const LayoutContext& context,
                       const LayoutPass& pass) {
  return PassChecker(layout, limits, context).pass(pass);
}

}  // namespace tyndall::host
