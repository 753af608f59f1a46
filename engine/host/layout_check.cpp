// The rules of the ABI, one function per kind of thing.
#include <bit>
#include <cmath>
#include <set>

#include "host/layout.hpp"

namespace tyndall::host {
namespace {

using Text = std::string;
Text str(std::uint64_t number) { return std::to_string(number); }

class Checker {
 public:
  Checker(const Layout& layout, const LayoutLimits& limits, const LayoutContext& context) : l_(layout), limits_(limits), context_(context) {}

  Result<void> all() {
    for (const LayoutImage& i : l_.images)
      if (auto r = image(i); !r) return r;
    for (const LayoutBuffer& b : l_.buffers)
      if (auto r = buffer(b); !r) return r;
    for (const LayoutUniform& u : l_.uniforms)
      if (u.d.size < 4 || u.d.size > 16384 || u.d.size % 4 != 0 || u.d.per_light > 1)
        return failed("uniform block '" + u.name + "': is " + str(u.d.size) + " bytes; 4 to 16384 in steps of 4 (and per_light 0 or 1)");
    for (const LayoutPass& p : l_.passes)
      if (auto r = pass(p); !r) return r;
    if (auto r = debugViews(); !r) return r;
    if (auto r = counters(); !r) return r;
    if (auto r = tunables(); !r) return r;
    return l_.passes.empty() ? Result<void>{} : order();
  }

 private:
  /// Names of images and buffers share one space: reports and debug views list them together.
  Result<void> unique(const Text& name) {
    if (!names_.insert(name).second) return failed("'" + name + "': names two images or buffers; names are unique");
    return {};
  }

  Result<void> image(const LayoutImage& i) {
    const TyImage& d = i.d;
    const auto bad = [&](const Text& what) { return failed("image '" + i.name + "': " + what); };
    if (auto r = unique(i.name); !r) return r;
    if (formatBytes(d.format) == 0) return bad("format " + str(d.format) + " is unknown; formats are 1 to 16");
    if (d.kind > TY_IMAGE_3D) return bad("kind " + str(d.kind) + " is unknown; kinds are 0 to 2");
    if ((d.flags & ~std::uint32_t{TY_RESOURCE_HISTORY}) != 0) return bad("has unknown flags " + str(d.flags));
    const std::uint32_t side = d.kind == TY_IMAGE_3D ? limits_.image3d : limits_.image2d;
    const std::uint32_t deep = d.kind == TY_IMAGE_2D ? 1 : d.kind == TY_IMAGE_3D ? limits_.image3d : limits_.layers;
    if (d.width < 1 || d.height < 1 || d.depth < 1 || d.width > side || d.height > side || d.depth > deep)
      return bad("is " + str(d.width) + "x" + str(d.height) + "x" + str(d.depth) + "; this kind goes from 1 to " + str(side) + "x" + str(side) + "x" + str(deep));
    const std::uint32_t longest = std::max({d.width, d.height, d.kind == TY_IMAGE_3D ? d.depth : 1u});
    const auto most = static_cast<std::uint32_t>(std::bit_width(longest));
    if (d.mips < 1 || d.mips > most) return bad("has " + str(d.mips) + " mips; its size allows 1 to " + str(most));
    if (d.format == TY_FORMAT_D32_FLOAT && d.kind == TY_IMAGE_3D) return bad("is a 3D depth image; depth images are 2D");
    return {};
  }

  Result<void> buffer(const LayoutBuffer& b) {
    if (auto r = unique(b.name); !r) return r;
    if (b.d.size < 4 || b.d.size % 4 != 0 || b.d.size > limits_.storageBuffer)
      return failed("buffer '" + b.name + "': is " + str(b.d.size) + " bytes; 4 to " + str(limits_.storageBuffer) + " in steps of 4");
    if ((b.d.flags & ~std::uint32_t{TY_RESOURCE_HISTORY}) != 0) return failed("buffer '" + b.name + "': has unknown flags " + str(b.d.flags));
    return {};
  }

  Result<void> pass(const LayoutPass& p) {
    const auto bad = [&](const Text& what) { return failed("pass '" + p.name + "': " + what); };
    const TyPass& d = p.d;
    if (d.kind == TY_PASS_SHADOW_VOLUMES) return bad("shadow volumes are not built yet (ability 'tyndall.shadow_volumes')");
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
    if (compute && (!p.targets.empty() || p.depthTarget)) return bad("is a compute pass with targets; only full-screen and caster passes have them");
    if (d.kind == TY_PASS_COMPUTE)
      for (int axis = 0; axis < 3; ++axis)
        if (d.groups[axis] < 1 || d.groups[axis] > limits_.groups[static_cast<std::size_t>(axis)])
          return bad("groups[" + str(static_cast<std::uint64_t>(axis)) + "] is " + str(d.groups[axis]) + "; 1 to " + str(limits_.groups[static_cast<std::size_t>(axis)]));
    if (d.kind == TY_PASS_COMPUTE_INDIRECT) {
      if (d.indirect_buffer >= l_.buffers.size()) return bad("indirect buffer " + str(d.indirect_buffer) + " is out of range; there are " + str(l_.buffers.size()));
      const std::uint64_t size = l_.buffers[d.indirect_buffer].d.size;
      if (d.indirect_offset % 4 != 0 || size < 12 || d.indirect_offset > size - 12)
        return bad("indirect_offset " + str(d.indirect_offset) + " leaves no three aligned counts in " + str(size) + " bytes");
    }
    if (!compute)
      if (auto r = targets(p); !r) return bad(r.error().message);
    if (d.kind == TY_PASS_CASTERS)
      if (auto r = casters(p); !r) return bad(r.error().message);
    if (auto uses = usesOf(l_, p); !uses) return uses.error();
    return {};
  }

  Result<void> shader(const LayoutPass& p, const Text& ending) {
    if (ending.empty()) return {};
    bool plain = p.shader.size() > ending.size() && p.shader.size() <= 128 && p.shader.ends_with(ending) && p.shader[0] != '.';
    for (const char c : p.shader) plain = plain && (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-');
    if (!plain) return failed("pass '" + p.name + "': shader '" + p.shader + "' is no plain file name ending in " + ending);
    return {};
  }

  Result<void> binding(const LayoutPass& p, const TyBinding& b, bool compute) {
    const auto limit = [&](std::size_t count, const char* what) -> Result<void> {
      if (b.index < count) return {};
      return failed(Text("refers to ") + what + " " + str(b.index) + "; there are " + str(count));
    };
    if (b.access > TY_ACCESS_UNIFORM) return failed("has unknown access " + str(b.access));
    if ((b.access == TY_ACCESS_UNIFORM) != (b.source == TY_SOURCE_UNIFORM)) return failed("mixes uniform access with another source, or the reverse");
    const bool storage = b.access != TY_ACCESS_SAMPLED && b.access != TY_ACCESS_UNIFORM;
    if (storage && !compute && !(b.source == TY_SOURCE_BUFFER && b.access == TY_ACCESS_STORAGE_READ))
      return failed("stores or loads an image by storage access, or writes a buffer; only compute passes do");
    std::uint32_t format = TY_FORMAT_D32_FLOAT, mips = 1, layers = 1;
    switch (b.source) {
      case TY_SOURCE_UNIFORM:
        if (auto r = limit(l_.uniforms.size(), "uniform block"); !r) return r;
        if (l_.uniforms[b.index].d.per_light && !p.d.per_light) return failed("takes a per-light uniform block in a pass that is not per light");
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
      case TY_SOURCE_SHADOW_MAP:
        if (!p.d.per_light) return failed("takes a shadow map in a pass that is not per light");
        layers = TY_NONE;  // 1 or 6, by the light: only the whole array can be bound
        if (b.base_layer != 0 || b.layer_count != 0) return failed("takes a part of a shadow map; bind all of it");
        break;
      case TY_SOURCE_SCENE_DEPTH: break;
      default: return failed("has unknown source " + str(b.source));
    }
    if (b.source != TY_SOURCE_IMAGE && b.index != 0) return failed("has index " + str(b.index) + "; this source has only index 0");
    if (storage && format == TY_FORMAT_D32_FLOAT) return failed("stores to or loads from a depth image; sample it");
    if (b.base_mip >= mips || b.mip_count > mips - b.base_mip) return failed("takes mips beyond the image's " + str(mips));
    if (b.base_layer >= layers || b.layer_count > layers - b.base_layer) return failed("takes layers beyond the image's " + str(layers));
    if (storage && b.mip_count > 1) return failed("takes several mips by storage access; bind one");
    if (b.access == TY_ACCESS_SAMPLED) {
      if (b.sampler > TY_SAMPLER_LINEAR_MIPMAP_CLAMP) return failed("has unknown sampler " + str(b.sampler));
      const bool nearest = b.sampler == TY_SAMPLER_NEAREST_CLAMP || b.sampler == TY_SAMPLER_NEAREST_REPEAT;
      if (!nearest && (format == TY_FORMAT_D32_FLOAT || isInteger(format)))
        return failed("filters a depth or integer format linearly; take a nearest sampler");
    }
    return {};
  }

  Result<void> targets(const LayoutPass& p) {
    if (p.targets.empty() && !p.depthTarget) return failed("draws to no target; give one");
    if (p.targets.size() > limits_.colorTargets) return failed("has " + str(p.targets.size()) + " targets; at most " + str(limits_.colorTargets));
    std::uint32_t width = 0, height = 0;
    const auto one = [&](const TyTarget& t, bool depth) -> Result<void> {
      TyImage image{};
      image.format = TY_FORMAT_RGBA32_FLOAT;
      image.width = context_.width;
      image.height = context_.height;
      image.depth = image.mips = 1;
      if (t.source == TY_SOURCE_IMAGE) {
        if (t.index >= l_.images.size()) return failed("target image " + str(t.index) + " is out of range; there are " + str(l_.images.size()));
        image = l_.images[t.index].d;
      } else if (t.source != TY_SOURCE_OUTPUT || t.index != 0) {
        return failed("a target is neither an image nor the output");
      }
      if (image.kind == TY_IMAGE_3D) return failed("draws to a 3D image; store to it from a compute pass");
      if ((image.format == TY_FORMAT_D32_FLOAT) != depth) return failed(depth ? "the depth target is no depth image" : "a colour target is a depth image");
      if (t.mip >= image.mips || t.layer >= image.depth) return failed("a target's mip or layer is out of range");
      if (t.load > 1 || t.blend > TY_BLEND_MAX) return failed("a target's load is 0 or 1, its blend 0 to 3");
      if (!depth && t.blend != TY_BLEND_NONE && isInteger(image.format)) return failed("blends into an integer format");
      for (const float c : t.clear)
        if (!std::isfinite(c)) return failed("a target's clear value is not finite");
      if (depth && !(t.clear[0] >= 0 && t.clear[0] <= 1)) return failed("the depth target's clear value is outside [0, 1]");
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
    if (p.d.caster_uniform >= l_.uniforms.size()) return failed("caster_uniform " + str(p.d.caster_uniform) + " is out of range");
    const TyUniformBlock& block = l_.uniforms[p.d.caster_uniform].d;
    if (block.size < 64 || (block.per_light && !p.d.per_light)) return failed("caster_uniform is no block that starts with a mat4 for this pass");
    return {};
  }

  Result<void> debugViews() {
    std::set<Text> names;
    for (const LayoutDebugView& v : l_.debugViews) {
      const auto bad = [&](const Text& what) { return failed("debug view '" + v.name + "': " + what); };
      if (!names.insert(v.name).second) return bad("appears twice");
      if (v.d.channel > 4 || !std::isfinite(v.d.low) || !std::isfinite(v.d.high) || v.d.low == v.d.high)
        return bad("its channel is 0 to 4, low and high are two different finite numbers");
      if (v.d.source == TY_SOURCE_IMAGE) {
        if (v.d.index >= l_.images.size()) return bad("image " + str(v.d.index) + " is out of range; there are " + str(l_.images.size()));
        const TyImage& image = l_.images[v.d.index].d;
        if (image.kind == TY_IMAGE_3D || isInteger(image.format)) return bad("shows a 3D or integer image; show a 2D one of another format");
        if (v.d.mip >= image.mips || v.d.layer >= image.depth) return bad("its mip or layer is out of range");
      } else if (v.d.source == TY_SOURCE_SHADOW_MAP) {
        if (v.d.mip != 0 || v.d.layer >= 6) return bad("its mip or layer is out of range");
      } else if (v.d.source != TY_SOURCE_OUTPUT || v.d.index != 0 || v.d.mip != 0 || v.d.layer != 0) {
        return bad("its source is an image, a shadow map or the output");
      }
    }
    return {};
  }

  Result<void> counters() {
    if (!l_.counters) return {};
    if (l_.counters->buffer >= l_.buffers.size()) return failed("counters: buffer " + str(l_.counters->buffer) + " is out of range; there are " + str(l_.buffers.size()));
    const LayoutBuffer& b = l_.buffers[l_.counters->buffer];
    if (b.d.size < 4 * l_.counters->names.size()) return failed("counters: " + str(l_.counters->names.size()) + " names, but buffer '" + b.name + "' holds " + str(b.d.size / 4));
    if (isHistory(b)) return failed("counters: buffer '" + b.name + "' is kept between frames; the host clears it each frame, so it must be transient");
    return {};
  }

  Result<void> tunables() {
    std::set<std::uint32_t> seen;
    for (const LayoutTunable& t : l_.tunables) {
      const auto bad = [&](const Text& what) { return failed("tunable of parameter " + str(t.parameter) + ": " + what); };
      if (t.parameter >= context_.valueCount || !context_.structural[t.parameter]) return bad("is no structural parameter of the table");
      if (!seen.insert(t.parameter).second) return bad("appears twice");
      if (t.variants.empty() || t.passes.empty()) return bad("needs at least one variant and one pass to time");
      for (const double v : t.variants)
        if (!std::isfinite(v) || v == t.automatic) return bad("a variant is not finite or is the automatic value itself");
      for (const Text& name : t.passes)
        if (std::none_of(l_.passes.begin(), l_.passes.end(), [&](const LayoutPass& p) { return p.name == name; }))
          return bad("times the pass '" + name + "', which does not exist");
    }
    return {};
  }

  /// Walks the passes as they will run: what is read has been written, and the output is written at all.
  Result<void> order() {
    std::vector<LayoutResource> written;
    const auto known = [&](const LayoutResource& r) { return std::find(written.begin(), written.end(), r) != written.end(); };
    for (std::uint32_t i = 0; i < l_.images.size(); ++i)
      if (isHistory(l_.images[i])) written.push_back({TY_SOURCE_IMAGE, i});
    for (std::uint32_t i = 0; i < l_.buffers.size(); ++i)
      if (isHistory(l_.buffers[i]) || (l_.counters && l_.counters->buffer == i)) written.push_back({TY_SOURCE_BUFFER, i});
    for (const PassRun& run : expandPasses(l_, context_.lightKinds)) {
      const LayoutPass& p = l_.passes[run.pass];
      const auto uses = usesOf(l_, p);
      if (!uses) return uses.error();
      for (const PassUse& use : uses.value()) {
        const auto source = use.resource.source;
        if (source == TY_SOURCE_SCENE_DEPTH || source == TY_SOURCE_SHADOW_MAP) continue;
        const Text name = source == TY_SOURCE_OUTPUT ? Text("the output")
                          : source == TY_SOURCE_IMAGE ? "image '" + l_.images[use.resource.index].name + "'"
                                                      : "buffer '" + l_.buffers[use.resource.index].name + "'";
        if (readsOld(use.access) && !known(use.resource)) return failed("pass '" + p.name + "': reads " + name + ", which no earlier pass has written");
        if (writesTo(use.access) && !known(use.resource)) written.push_back(use.resource);
      }
    }
    if (!known({TY_SOURCE_OUTPUT, 0})) return failed("no pass writes the output (TY_SOURCE_OUTPUT); a layout without passes says that there is nothing to do");
    return {};
  }

  const Layout& l_;
  const LayoutLimits& limits_;
  const LayoutContext& context_;
  std::set<Text> names_;
};

}  // namespace

Result<void> checkLayout(const Layout& layout, const LayoutLimits& limits, const LayoutContext& context) {
  return Checker(layout, limits, context).all();
}

}  // namespace tyndall::host
