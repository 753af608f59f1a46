// A plugin for the GPU tests: per-light groups, blending full-screen passes, history, counters, an indirect dispatch,
// sub-views, a tunable. What each pixel of the output must be is computed again in effect_test.cpp.
//   output.r = output.g + sum over lights of (radiance.r * weight + 1000 * shadow depth), summed by additive
//   full-screen passes output.g = number of frames since the history was cleared output.b = what the indirect dispatch
//   stored through mip 1 of layer 1 of an array image output.a = 0.5
// Beside it a chain of mips, each pass sampling one mip and storing the next of the same image, that only the debug
// view "chain" shows. "passes.skip" is a mask of what prepare() leaves out: 1 history, 2 the second light, 4 the
// casters. "passes.moments" 1: in the place of the shadow depth stands what per_light_moments.comp reads of the moment
// shadow map, plus 10 times the map's TyFormat as layout() was told, which the weight of the light then includes.
// "passes.cookies" 1: what per_light_cookie.comp reads of the light's cookie stands there; the weight then includes ten
// times the faces that layout() was told of and what prepare() is told of the cookie. "passes.odd" 1 or a second light,
// but not both, make the first pass of the chain another pipeline that does the same.
#include <cstdint>
#include <cstring>
#include <vector>

#include "tyndall/plugin.h"

struct TyInstance {
  std::vector<TyImage> images;
  std::vector<TyBuffer> buffers;
  std::vector<TyUniformBlock> uniforms;
  std::vector<TyPass> passes;
  std::vector<std::vector<TyBinding>> bindings;
  std::vector<TyDebugView> views;
  TyTarget screen{}, lights{}, casterDepth{};
  TySpecialization size{}, first{};
  TyCounters counters{};
  TyTunable tunable{};
  std::uint32_t momentsFormat = 0;
  std::vector<std::uint32_t> cookies;
  TyLayout layout{};
};

namespace {

enum { kWeight, kVariant, kBreak, kSkip, kMoments, kCookies, kOdd, kParameters };
const char* const kVariants[] = {"auto", "one", "two"};
const char* const kBreaks[] = {"nothing", "shader", "binding", "pass", "huge", "null", "casters", "prepare"};
const TyHost* g_host = nullptr;

TyParameter parameter(const char* id, std::uint32_t type, double def, double max, const char* const* choices,
                      std::uint32_t count, std::uint32_t flags) {
  TyParameter p{};
  p.struct_size = sizeof p;
  p.type = type;
  p.id = id;
  p.name = p.unit = p.doc = "";
  p.default_value = def;
  p.max_value = max;
  p.choices = choices;
  p.choice_count = count;
  p.flags = flags;
  return p;
}
const TyParameter kTable[kParameters] = {
    parameter("passes.weight", TY_PARAMETER_FLOAT, 1, 100, nullptr, 0, 0),
    parameter("passes.variant", TY_PARAMETER_ENUM, 0, 0, kVariants, 3, TY_PARAMETER_STRUCTURAL),
    parameter("passes.break", TY_PARAMETER_ENUM, 0, 0, kBreaks, 8, TY_PARAMETER_STRUCTURAL),
    parameter("passes.skip", TY_PARAMETER_INT, 0, 7, nullptr, 0, 0),
    parameter("passes.moments", TY_PARAMETER_INT, 0, 1, nullptr, 0, TY_PARAMETER_STRUCTURAL),
    parameter("passes.cookies", TY_PARAMETER_INT, 0, 1, nullptr, 0, TY_PARAMETER_STRUCTURAL),
    parameter("passes.odd", TY_PARAMETER_INT, 0, 1, nullptr, 0, TY_PARAMETER_STRUCTURAL)};

TyBinding bind(std::uint32_t at, std::uint32_t source, std::uint32_t index, std::uint32_t access) {
  TyBinding b{};
  b.struct_size = sizeof b;
  b.binding = at;
  b.source = source;
  b.index = index;
  b.access = access;
  return b;
}

void image(TyInstance& s, const char* name, std::uint32_t format, std::uint32_t w, std::uint32_t h,
           std::uint32_t layers, std::uint32_t mips, std::uint32_t flags) {
  TyImage i{};
  i.struct_size = sizeof i;
  i.kind = layers > 1 ? TY_IMAGE_2D_ARRAY : TY_IMAGE_2D;
  i.name = name;
  i.format = format;
  i.width = w;
  i.height = h;
  i.depth = layers;
  i.mips = mips;
  i.flags = flags;
  s.images.push_back(i);
}

TyPass& pass(TyInstance& s, std::uint32_t kind, const char* name, const char* shader, std::vector<TyBinding> bindings) {
  s.bindings.push_back(std::move(bindings));
  TyPass p{};
  p.struct_size = sizeof p;
  p.kind = kind;
  p.name = name;
  p.shader = shader;
  p.binding_count = static_cast<std::uint32_t>(s.bindings.back().size());
  p.groups[0] = p.groups[1] = p.groups[2] = 1;
  s.passes.push_back(p);
  return s.passes.back();
}

const TyLayout* layout(TyInstance* self, const TyDevice*, const TyStructure* structure) {
  TyInstance& s = *self;
  s = TyInstance{};
  const std::uint32_t w = structure->width, h = structure->height;
  const auto broken = static_cast<std::uint32_t>(structure->values[kBreak]);
  if (broken == 5) {
    g_host->log(g_host->context, TY_LOG_ERROR, "no layout today");
    return nullptr;
  }
  s.uniforms.push_back({sizeof(TyUniformBlock), 1, "light", 32});
  s.uniforms.push_back({sizeof(TyUniformBlock), 0, "frame", 16});
  image(s, "one light", TY_FORMAT_RGBA32_FLOAT, w, h, 1, 1, 0);
  image(s, "all lights", TY_FORMAT_RGBA32_FLOAT, w, h, 1, 1, 0);
  image(s, "frames", TY_FORMAT_R32_FLOAT, w, h, 1, 1, TY_RESOURCE_HISTORY);
  image(s, "layers", TY_FORMAT_R32_FLOAT, broken == 4 ? 16384u : 2 * w, broken == 4 ? 16384u : 2 * h,
        broken == 4 ? 2048u : 3u, 2, 0);
  image(s, "chain", TY_FORMAT_R32_FLOAT, 32, 16, 1, 4, 0);
  s.buffers.push_back({sizeof(TyBuffer), 0, "arguments", 16});
  s.buffers.push_back({sizeof(TyBuffer), 0, "counted", 8});
  s.buffers.push_back({sizeof(TyBuffer), TY_RESOURCE_HISTORY, "kept", 16});
  const std::uint32_t gx = (w + 7) / 8, gy = (h + 7) / 8;
  s.size = {0, structure->values[kVariant] == 2 ? 4u : 8u};

  pass(s, TY_PASS_COMPUTE, "arguments", broken == 2 ? "extra_binding.comp" : "arguments.comp",
       {bind(0, TY_SOURCE_BUFFER, 0, TY_ACCESS_STORAGE_WRITE), bind(1, TY_SOURCE_UNIFORM, 1, TY_ACCESS_UNIFORM)});
  TyBinding part = bind(0, TY_SOURCE_IMAGE, 3, TY_ACCESS_STORAGE_WRITE);
  part.base_mip = 1;
  part.base_layer = 1;
  part.layer_count = 1;
  pass(s, TY_PASS_COMPUTE_INDIRECT, "count", broken == 1 ? "missing.comp" : "count.comp",
       {part, bind(1, TY_SOURCE_BUFFER, 1, TY_ACCESS_STORAGE_READ_WRITE)})
      .indirect_offset = 4;
  pass(s, TY_PASS_COMPUTE, "history", "history.comp",
       {bind(0, TY_SOURCE_IMAGE, 2, TY_ACCESS_STORAGE_READ_WRITE),
        bind(1, TY_SOURCE_BUFFER, 2, TY_ACCESS_STORAGE_READ_WRITE)});
  s.passes.back().groups[0] = gx, s.passes.back().groups[1] = gy;
  TyPass& light =
      pass(s, TY_PASS_COMPUTE, "light", "per_light.comp",
           {bind(0, TY_SOURCE_IMAGE, 0, TY_ACCESS_STORAGE_WRITE), bind(1, TY_SOURCE_UNIFORM, 0, TY_ACCESS_UNIFORM),
            bind(2, TY_SOURCE_SHADOW_MAP, 0, TY_ACCESS_SAMPLED)});
  const bool moments = structure->values[kMoments] != 0;
  s.momentsFormat = structure->shadow_moments_format;
  if (moments) {
    light.shader = "per_light_moments.comp";
    s.bindings.back()[2] = bind(2, TY_SOURCE_SHADOW_MOMENTS, 0, TY_ACCESS_SAMPLED);
    s.bindings.back()[2].sampler = TY_SAMPLER_LINEAR_MIPMAP_CLAMP;
  }
  if (structure->light_cookies)
    s.cookies.assign(structure->light_cookies, structure->light_cookies + structure->light_count);
  if (structure->values[kCookies] != 0) {
    light.shader = "per_light_cookie.comp";
    s.bindings.back()[2] = bind(2, TY_SOURCE_LIGHT_COOKIE, 0, TY_ACCESS_SAMPLED);
    s.bindings.back()[2].sampler = TY_SAMPLER_LINEAR_MIPMAP_REPEAT;
  }
  light.per_light = 1;
  light.groups[0] = (w + s.size.value - 1) / s.size.value, light.groups[1] = (h + s.size.value - 1) / s.size.value;
  light.specialization_count = 1;
  TyPass& sum = pass(s, TY_PASS_FULL_SCREEN, "add", "screen.frag", {bind(0, TY_SOURCE_IMAGE, 0, TY_ACCESS_SAMPLED)});
  sum.per_light = 1;
  s.lights = {sizeof(TyTarget), TY_SOURCE_IMAGE, 1, 0, 0, 1, TY_BLEND_ADD, {}};
  sum.target_count = 1;
  TyPass clear = sum;  // before the group of lights, which all add to what it drew
  clear.name = "clear";
  clear.per_light = 0;
  clear.target_count = 1;
  s.screen = {sizeof(TyTarget), TY_SOURCE_IMAGE, 1, 0, 0, 0, TY_BLEND_NONE, {}};
  clear.binding_count = 1;
  s.bindings.insert(s.bindings.begin() + 3, {bind(0, TY_SOURCE_IMAGE, 2, TY_ACCESS_SAMPLED)});
  s.passes.insert(s.passes.begin() + 3, clear);
  pass(s, TY_PASS_COMPUTE, "accumulate", "accumulate.comp",
       {bind(0, TY_SOURCE_OUTPUT, 0, TY_ACCESS_STORAGE_WRITE), bind(1, TY_SOURCE_IMAGE, 1, TY_ACCESS_SAMPLED),
        bind(2, TY_SOURCE_IMAGE, 2, TY_ACCESS_SAMPLED), bind(3, TY_SOURCE_IMAGE, 3, TY_ACCESS_SAMPLED)});
  s.passes.back().groups[0] = gx, s.passes.back().groups[1] = gy;
  if (broken == 3) s.passes.back().groups[2] = 0;
  s.first = {0, (structure->values[kOdd] != 0) != (structure->light_count > 1) ? 2u : 1u};
  for (std::uint32_t mip = 0; mip < 4; ++mip) {
    TyBinding to = bind(0, TY_SOURCE_IMAGE, 4, TY_ACCESS_STORAGE_WRITE),
              from = bind(1, TY_SOURCE_IMAGE, 2, TY_ACCESS_SAMPLED);
    to.base_mip = mip;
    if (mip > 0) from.index = 4, from.base_mip = mip - 1, from.mip_count = 1;
    TyPass& chain = pass(s, TY_PASS_COMPUTE, mip ? "chain" : "chain start", "chain.comp", {to, from});
    chain.groups[0] = 4, chain.groups[1] = 2;
    chain.specialization_count = mip ? 0 : 1;
  }
  if (broken == 6) {
    TyPass casters{};
    casters.struct_size = sizeof casters;
    casters.kind = TY_PASS_CASTERS;
    casters.name = "casters";
    image(s, "caster depth", TY_FORMAT_D32_FLOAT, 16, 16, 1, 1, TY_RESOURCE_HISTORY);  // kept, so the pass has a reader
    casters.caster_uniform = 2;
    s.uniforms.push_back({sizeof(TyUniformBlock), 0, "casters", 64});
    s.casterDepth = {sizeof(TyTarget), TY_SOURCE_IMAGE, 5, 0, 0, 0, 0, {}};
    s.bindings.push_back({});
    casters.depth_target = &s.casterDepth;
    s.passes.push_back(casters);
  }
  for (std::size_t i = 0; i < s.passes.size(); ++i) {
    s.passes[i].bindings = s.bindings[i].data();
    if (s.passes[i].specialization_count)
      s.passes[i].specializations = std::strcmp(s.passes[i].name, "chain start") == 0 ? &s.first : &s.size;
    if (s.passes[i].target_count) s.passes[i].targets = s.passes[i].per_light ? &s.lights : &s.screen;
  }
  static const char* const names[] = {"groups run", "twice that"};
  s.counters = {sizeof(TyCounters), 1, names, 2};
  static const double variants[] = {1, 2};
  static const char* const timed[] = {"light"};
  s.tunable = {sizeof(TyTunable), kVariant, 0, variants, 2, timed, 1};
  s.views.push_back({sizeof(TyDebugView), TY_SOURCE_IMAGE, "sum", "All lights", 1, 0, 0, 0, 0, 1});
  s.views.push_back({sizeof(TyDebugView), TY_SOURCE_IMAGE, "part", "Mip 1 of layer 1", 3, 1, 1, 0, 0, 1});
  s.views.push_back({sizeof(TyDebugView), TY_SOURCE_SHADOW_MAP, "map of light 7", "", 7, 0, 0, 0, 0, 1});
  if (moments) s.views.push_back({sizeof(TyDebugView), TY_SOURCE_SHADOW_MOMENTS, "moments", "", 0, 0, 0, 2, 0, 1});
  s.views.push_back({sizeof(TyDebugView), TY_SOURCE_IMAGE, "chain", "Mip 3 of the chain", 4, 3, 0, 0, 0, 1});

  s.layout.struct_size = sizeof(TyLayout);
  s.layout.images = s.images.data(), s.layout.image_count = static_cast<std::uint32_t>(s.images.size());
  s.layout.buffers = s.buffers.data(), s.layout.buffer_count = static_cast<std::uint32_t>(s.buffers.size());
  s.layout.uniforms = s.uniforms.data(), s.layout.uniform_count = static_cast<std::uint32_t>(s.uniforms.size());
  s.layout.passes = s.passes.data(), s.layout.pass_count = static_cast<std::uint32_t>(s.passes.size());
  s.layout.debug_views = s.views.data(), s.layout.debug_view_count = static_cast<std::uint32_t>(s.views.size());
  s.layout.counters = &s.counters;
  s.layout.tunables = &s.tunable, s.layout.tunable_count = 1;
  return &s.layout;
}

void skip(const TyInstance& s, const TyFrame* frame, const TyUniformData* out) {
  const auto mask = static_cast<std::uint32_t>(frame->values[kSkip]);
  for (std::uint32_t p = 0; p < s.passes.size(); ++p) {
    const TyPass& pass = s.passes[p];
    std::uint8_t* flags = out->skip + std::size_t{p} * out->skip_stride;
    if ((mask & 1) && std::strcmp(pass.name, "history") == 0) flags[0] = 1;
    if ((mask & 2) && pass.per_light) flags[1] = 1;
    if ((mask & 4) && pass.kind == TY_PASS_CASTERS) flags[0] = 1;
  }
}

bool prepare(TyInstance* self, const TyFrame* frame, const TyUniformData* out) {
  if (frame->values[kBreak] == 7) return false;
  skip(*self, frame, out);
  for (std::uint32_t i = 0; i < frame->light_count; ++i) {
    float block[8] = {frame->lights[i].radiance[0] * static_cast<float>(frame->values[kWeight]), 0, 0, 0, 0, 0, 0, 0};
    if (frame->values[kMoments] != 0) block[0] += 10 * static_cast<float>(self->momentsFormat);
    if (frame->values[kCookies] != 0) {
      const TyLight& light = frame->lights[i];
      block[0] += static_cast<float>(10 * self->cookies.at(i) + light.cookie_faces + light.cookie_repeats) +
                  light.cookie_from_world[12];
    }
    std::memcpy(out->data[0] + std::size_t{i} * out->stride[0], block, sizeof block);
  }
  const float scalars[4] = {static_cast<float>(frame->reset), 0, 0, 0};
  std::memcpy(out->data[1], scalars, sizeof scalars);
  if (frame->values[kBreak] == 6)
    for (int i = 0; i < 16; ++i) {
      const float element = static_cast<float>(i);
      std::memcpy(out->data[2] + 4 * i, &element, sizeof element);
    }
  return true;
}

}  // namespace

extern "C" {
TY_EXPORT extern const TyPlugin tyndall_plugin;
const TyPlugin tyndall_plugin = {
    .abi_version = TY_ABI_VERSION,
    .struct_size = sizeof(TyPlugin),
    .id = "passes",
    .name = "Passes",
    .version = "1.0.0",
    .doc = "For tests.",
    .init =
        [](const TyHost* host) {
          g_host = host;
          return true;
        },
    .shutdown = [] {},
    .parameters =
        [](std::uint32_t* count) {
          *count = kParameters;
          return static_cast<const TyParameter*>(kTable);
        },
    .techniques = nullptr,
    .create = [] { return new TyInstance; },
    .destroy = [](TyInstance* s) { delete s; },
    .layout = layout,
    .prepare = prepare,
    .get_extension = nullptr,
};
}
