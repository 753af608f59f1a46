// The rules of the ABI, one function per kind of thing; those of passes are in layout_check_pass.cpp.
#include <bit>
#include <cmath>
#include <set>

#include "layout_check_pass.hpp"

namespace tyndall::host {
namespace {

using Text = std::string;
Text str(std::uint64_t number) { return std::to_string(number); }

class Checker {
 public:
  Checker(const Layout& layout, const LayoutLimits& limits, const LayoutContext& context)
      : l_(layout), limits_(limits), context_(context) {}

  Result<void> all() {
    for (const LayoutImage& i : l_.images)
      if (auto r = image(i); !r) return r;
    for (const LayoutBuffer& b : l_.buffers)
      if (auto r = buffer(b); !r) return r;
    for (const LayoutUniform& u : l_.uniforms)
      if (u.d.size < 4 || u.d.size > 16384 || u.d.size % 4 != 0 || u.d.per_light > 1)
        return failed("uniform block '" + u.name + "': is " + str(u.d.size) +
                      " bytes; 4 to 16384 in steps of 4 (and per_light 0 or 1)");
    for (const LayoutPass& p : l_.passes)
      if (auto r = checkPass(l_, limits_, context_, p); !r) return r;
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
      return bad("is " + str(d.width) + "x" + str(d.height) + "x" + str(d.depth) + "; this kind goes from 1 to " +
                 str(side) + "x" + str(side) + "x" + str(deep));
    const std::uint32_t longest = std::max({d.width, d.height, d.kind == TY_IMAGE_3D ? d.depth : 1u});
    const auto most = static_cast<std::uint32_t>(std::bit_width(longest));
    if (d.mips < 1 || d.mips > most) return bad("has " + str(d.mips) + " mips; its size allows 1 to " + str(most));
    if (d.format == TY_FORMAT_D32_FLOAT && d.kind == TY_IMAGE_3D)
      return bad("is a 3D depth image; depth images are 2D");
    return {};
  }

  Result<void> buffer(const LayoutBuffer& b) {
    if (auto r = unique(b.name); !r) return r;
    if (b.d.size < 4 || b.d.size % 4 != 0 || b.d.size > limits_.storageBuffer)
      return failed("buffer '" + b.name + "': is " + str(b.d.size) + " bytes; 4 to " + str(limits_.storageBuffer) +
                    " in steps of 4");
    if ((b.d.flags & ~std::uint32_t{TY_RESOURCE_HISTORY}) != 0)
      return failed("buffer '" + b.name + "': has unknown flags " + str(b.d.flags));
    return {};
  }

  Result<void> debugViews() {
    std::set<Text> names;
    std::set<std::uint32_t> roles;
    for (const LayoutDebugView& v : l_.debugViews) {
      const auto bad = [&](const Text& what) { return failed("debug view '" + v.name + "': " + what); };
      if (!names.insert(v.name).second) return bad("appears twice");
      const bool many =
          v.d.role < TY_VIEW_ROW_PLACE || v.d.role == TY_VIEW_WALK_LEVEL || v.d.role == TY_VIEW_WALK_LEVEL_ACROSS;
      if (!many && !roles.insert(v.d.role).second)
        return bad("has the role " + str(v.d.role) + " of another view; one view of a layout may have it");
      if (v.d.channel > 4 || !std::isfinite(v.d.low) || !std::isfinite(v.d.high) || v.d.low == v.d.high)
        return bad("its channel is 0 to 4, low and high are two different finite numbers");
      if (v.d.source == TY_SOURCE_IMAGE) {
        if (v.d.index >= l_.images.size())
          return bad("image " + str(v.d.index) + " is out of range; there are " + str(l_.images.size()));
        const TyImage& image = l_.images[v.d.index].d;
        if (image.kind == TY_IMAGE_3D || isInteger(image.format))
          return bad("shows a 3D or integer image; show a 2D one of another format");
        if (v.d.mip >= image.mips || v.d.layer >= image.depth) return bad("its mip or layer is out of range");
      } else if (v.d.source == TY_SOURCE_SHADOW_MAP || v.d.source == TY_SOURCE_SHADOW_MOMENTS) {
        if (v.d.mip != 0 || v.d.layer >= 6) return bad("its mip or layer is out of range");
      } else if (v.d.source != TY_SOURCE_OUTPUT || v.d.index != 0 || v.d.mip != 0 || v.d.layer != 0) {
        return bad("its source is an image, a shadow map, a moment shadow map or the output");
      }
    }
    return {};
  }

  Result<void> counters() {
    if (!l_.counters) return {};
    if (l_.counters->buffer >= l_.buffers.size())
      return failed("counters: buffer " + str(l_.counters->buffer) + " is out of range; there are " +
                    str(l_.buffers.size()));
    const LayoutBuffer& b = l_.buffers[l_.counters->buffer];
    if (b.d.size < 4 * l_.counters->names.size())
      return failed("counters: " + str(l_.counters->names.size()) + " names, but buffer '" + b.name + "' holds " +
                    str(b.d.size / 4));
    if (isHistory(b))
      return failed("counters: buffer '" + b.name +
                    "' is kept between frames; the host clears it each frame, so it must be transient");
    return {};
  }

  Result<void> tunables() {
    std::set<std::uint32_t> seen;
    for (const LayoutTunable& t : l_.tunables) {
      const auto bad = [&](const Text& what) {
        return failed("tunable of parameter " + str(t.parameter) + ": " + what);
      };
      if (t.parameter >= context_.valueCount || !context_.structural[t.parameter])
        return bad("is no structural parameter of the table");
      if (!seen.insert(t.parameter).second) return bad("appears twice");
      if (t.variants.empty() || t.passes.empty()) return bad("needs at least one variant and one pass to time");
      for (const double v : t.variants)
        if (!std::isfinite(v) || v == t.automatic)
          return bad("a variant is not finite or is the automatic value itself");
      for (const Text& name : t.passes)
        if (std::none_of(l_.passes.begin(), l_.passes.end(), [&](const LayoutPass& p) { return p.name == name; }))
          return bad("times the pass '" + name + "', which does not exist");
    }
    return {};
  }

  /// Walks the passes as they will run: what is read has been written, and the output is written at all.
  Result<void> order() {
    std::vector<LayoutResource> written;
    const auto known = [&](const LayoutResource& r) {
      return std::find(written.begin(), written.end(), r) != written.end();
    };
    for (std::uint32_t i = 0; i < l_.images.size(); ++i)
      if (isHistory(l_.images[i])) written.push_back({TY_SOURCE_IMAGE, i});
    for (std::uint32_t i = 0; i < l_.buffers.size(); ++i)
      if (isHistory(l_.buffers[i]) || (l_.counters && l_.counters->buffer == i))
        written.push_back({TY_SOURCE_BUFFER, i});
    for (const PassRun& run : expandPasses(l_, context_.lightKinds)) {
      const LayoutPass& p = l_.passes[run.pass];
      const auto uses = usesOf(l_, p);
      if (!uses) return uses.error();
      for (const PassUse& use : uses.value()) {
        const auto source = use.resource.source;
        if (source == TY_SOURCE_SCENE_DEPTH || source == TY_SOURCE_SHADOW_MAP || source == TY_SOURCE_SHADOW_MOMENTS ||
            source == TY_SOURCE_LIGHT_COOKIE)
          continue;
        const Text name = source == TY_SOURCE_OUTPUT  ? Text("the output")
                          : source == TY_SOURCE_IMAGE ? "image '" + l_.images[use.resource.index].name + "'"
                                                      : "buffer '" + l_.buffers[use.resource.index].name + "'";
        if (readsOld(use.access) && !known(use.resource))
          return failed("pass '" + p.name + "': reads " + name + ", which no earlier pass has written");
        if (writesTo(use.access) && !known(use.resource)) written.push_back(use.resource);
      }
    }
    if (!known({TY_SOURCE_OUTPUT, 0}))
      return failed(
          "no pass writes the output (TY_SOURCE_OUTPUT); a layout without passes says that there is nothing to do");
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
