// A layout with everything in it, and what is said about each way of spoiling it.
#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/layout.hpp"

namespace tyndall::host {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

enum Image { kFlat, kArray, kVolume, kDepth, kUint, kHistory, kImageCount };
enum Pass { kFill, kLight, kSum, kScreen, kCasters, kIndirect, kPassCount };

/// The plugin's side: plain arrays that may be spoilt before they are handed over.
struct Given {
  TyImage images[kImageCount]{};
  TyBuffer buffers[2]{};
  TyUniformBlock uniforms[2]{};
  TyBinding bindings[kPassCount][4]{};
  TyTarget targets[2]{}, depth{}, screenDepth{};
  TySpecialization constants[2]{{0, 8}, {1, 8}};
  TyPass passes[kPassCount]{};
  TyDebugView views[3]{};
  const char* counterNames[2] = {"skipped: far", "skipped: dark"};
  TyCounters counters{};
  double variants[2] = {1, 2};
  const char* timed[1] = {"fill"};
  TyTunable tunables[1]{};
  TyLayout layout{};
  LayoutContext context{64, 32, {TY_LIGHT_DIRECTIONAL, TY_LIGHT_SPOT}, 2, {true, false}};

  Given() {
    const char* names[] = {"flat", "array", "volume", "depth", "uint", "history"};
    const std::uint32_t formats[] = {TY_FORMAT_RGBA16_FLOAT, TY_FORMAT_RGBA8_UNORM, TY_FORMAT_R16_FLOAT,
                                     TY_FORMAT_D32_FLOAT,    TY_FORMAT_R32_UINT,    TY_FORMAT_R32_FLOAT};
    for (std::uint32_t i = 0; i < kImageCount; ++i) {
      images[i] = {sizeof(TyImage), TY_IMAGE_2D, names[i], formats[i], 64, 32, 1, 1, 0};
    }
    images[kArray].kind = TY_IMAGE_2D_ARRAY;
    images[kArray].depth = 4;
    images[kArray].mips = 6;
    images[kVolume].kind = TY_IMAGE_3D;
    images[kVolume].depth = 16;
    images[kHistory].flags = TY_RESOURCE_HISTORY;
    buffers[0] = {sizeof(TyBuffer), 0, "arguments", 64};
    buffers[1] = {sizeof(TyBuffer), 0, "counted", 8};
    uniforms[0] = {sizeof(TyUniformBlock), 0, "frame", 128};
    uniforms[1] = {sizeof(TyUniformBlock), 1, "light", 80};

    pass(kFill, TY_PASS_COMPUTE, "fill", "fill.comp",
         {bind(0, TY_SOURCE_SCENE_DEPTH, 0, TY_ACCESS_SAMPLED),
          bind(1, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_WRITE),
          bind(2, TY_SOURCE_BUFFER, 0, TY_ACCESS_STORAGE_WRITE), bind(3, TY_SOURCE_UNIFORM, 0, TY_ACCESS_UNIFORM)});
    passes[kFill].specializations = constants;
    passes[kFill].specialization_count = 2;
    pass(kLight, TY_PASS_COMPUTE, "light", "light.comp",
         {bind(0, TY_SOURCE_SHADOW_MAP, 0, TY_ACCESS_SAMPLED), bind(1, TY_SOURCE_UNIFORM, 1, TY_ACCESS_UNIFORM),
          bind(2, TY_SOURCE_IMAGE, kFlat, TY_ACCESS_STORAGE_WRITE),
          bind(3, TY_SOURCE_IMAGE, kArray, TY_ACCESS_SAMPLED)});
    pass(kSum, TY_PASS_COMPUTE, "sum", "sum.comp",
         {bind(0, TY_SOURCE_IMAGE, kFlat, TY_ACCESS_SAMPLED),
          bind(1, TY_SOURCE_IMAGE, kHistory, TY_ACCESS_STORAGE_READ_WRITE),
          bind(2, TY_SOURCE_IMAGE, kVolume, TY_ACCESS_STORAGE_WRITE),
          bind(3, TY_SOURCE_BUFFER, 1, TY_ACCESS_STORAGE_READ_WRITE)});
    passes[kLight].per_light = passes[kSum].per_light = 1;
    passes[kSum].light_kinds = 1u << TY_LIGHT_DIRECTIONAL;
    pass(kScreen, TY_PASS_FULL_SCREEN, "screen", "screen.frag",
         {bind(0, TY_SOURCE_IMAGE, kVolume, TY_ACCESS_SAMPLED, TY_SAMPLER_LINEAR_CLAMP),
          bind(1, TY_SOURCE_BUFFER, 0, TY_ACCESS_STORAGE_READ)});
    targets[0] = {sizeof(TyTarget), TY_SOURCE_OUTPUT, 0, 0, 0, 0, TY_BLEND_ADD, {}};
    targets[1] = {sizeof(TyTarget), TY_SOURCE_IMAGE, kUint, 0, 0, 0, TY_BLEND_NONE, {}};
    screenDepth = depth = {sizeof(TyTarget), TY_SOURCE_IMAGE, kDepth, 0, 0, 0, 0, {1, 0, 0, 0}};
    passes[kScreen].targets = targets;
    passes[kScreen].target_count = 2;
    passes[kScreen].depth_target = &screenDepth;
    pass(kCasters, TY_PASS_CASTERS, "casters", nullptr, {});
    passes[kCasters].depth_target = &depth;
    passes[kCasters].caster_uniform = 1;
    passes[kCasters].per_light = 1;
    pass(kIndirect, TY_PASS_COMPUTE_INDIRECT, "indirect", "indirect.comp",
         {bind(0, TY_SOURCE_OUTPUT, 0, TY_ACCESS_STORAGE_READ_WRITE),
          bind(1, TY_SOURCE_IMAGE, kDepth, TY_ACCESS_SAMPLED)});
    passes[kIndirect].indirect_buffer = 0;
    passes[kIndirect].indirect_offset = 52;

    views[0] = {sizeof(TyDebugView), TY_SOURCE_IMAGE, "flat", "", kFlat, 0, 0, 4, 0, 1};
    views[1] = {sizeof(TyDebugView), TY_SOURCE_SHADOW_MAP, "map", "", 0, 0, 0, 0, 0, 1};
    views[2] = {sizeof(TyDebugView), TY_SOURCE_OUTPUT, "result", "", 0, 0, 0, 3, 1, 0};
    counters = {sizeof(TyCounters), 1, counterNames, 2};
    tunables[0] = {sizeof(TyTunable), 0, 0, variants, 2, timed, 1};

    layout.struct_size = sizeof layout;
    layout.images = images, layout.image_count = kImageCount;
    layout.buffers = buffers, layout.buffer_count = 2;
    layout.uniforms = uniforms, layout.uniform_count = 2;
    layout.passes = passes, layout.pass_count = kPassCount;
    layout.debug_views = views, layout.debug_view_count = 3;
    layout.counters = &counters;
    layout.tunables = tunables, layout.tunable_count = 1;
  }

  static TyBinding bind(std::uint32_t at, std::uint32_t source, std::uint32_t index, std::uint32_t access,
                        std::uint32_t sampler = TY_SAMPLER_NEAREST_CLAMP) {
    return {sizeof(TyBinding), at, source, index, access, sampler, 0, 0, 0, 0};
  }
  void pass(std::uint32_t i, std::uint32_t kind, const char* name, const char* shader,
            std::initializer_list<TyBinding> list) {
    std::copy(list.begin(), list.end(), bindings[i]);
    TyPass& p = passes[i];
    p.struct_size = sizeof p;
    p.kind = kind;
    p.name = name;
    p.shader = shader;
    p.bindings = bindings[i];
    p.binding_count = static_cast<std::uint32_t>(list.size());
    p.groups[0] = p.groups[1] = p.groups[2] = 4;
  }

  Result<void> check() const {
    auto copy = copyLayout(&layout);
    if (!copy) return copy.error();
    return checkLayout(*copy, LayoutLimits{}, context);
  }
};

TEST(Layout, theGoodOneIsTaken) {
  Given given;
  const auto good = given.check();
  EXPECT_TRUE(good) << good.error().message;
}

TEST(Layout, onePassMayReadSomePartsOfAnImageAndWriteOthers) {
  const auto use = [](const Given& g) {
    auto copy = copyLayout(&g.layout);
    const auto uses = usesOf(*copy, copy->passes[kLight]);
    EXPECT_TRUE(g.check()) << g.check().error().message;
    for (const PassUse& u : uses.value())
      if (u.resource == LayoutResource{TY_SOURCE_IMAGE, kArray}) return u.access;
    return PassAccess::kIndirect;
  };
  Given mips;  // samples mips 0 and 1, stores to mip 2
  mips.bindings[kLight][1] = Given::bind(1, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_WRITE);
  mips.bindings[kLight][1].base_mip = 2;
  mips.bindings[kLight][3].mip_count = 2;
  EXPECT_EQ(use(mips), PassAccess::kSampledStorage);
  Given layers;  // samples layers 0 and 1, loads and stores the rest
  layers.bindings[kLight][1] = Given::bind(1, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_READ_WRITE);
  layers.bindings[kLight][1].base_layer = 2;
  layers.bindings[kLight][3].layer_count = 2;
  EXPECT_EQ(use(layers), PassAccess::kSampledStorage);
  Given stores;  // two mips at once
  stores.bindings[kLight][1] = stores.bindings[kLight][3] =
      Given::bind(1, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_WRITE);
  stores.bindings[kLight][3].binding = 3;
  stores.bindings[kLight][3].base_mip = 1;
  EXPECT_EQ(use(stores), PassAccess::kStorageWrite);
  EXPECT_TRUE(readsOld(PassAccess::kSampledStorage) && writesTo(PassAccess::kSampledStorage));
}

TEST(Layout, bytesMovedAreThoseOfEveryPartOnceInEachDirection) {
  Given given;
  auto copy = copyLayout(&given.layout);
  ASSERT_TRUE(copy);
  const auto moved = [&](std::uint32_t pass) { return bytesMoved(*copy, copy->passes[pass], 1000); };
  constexpr std::uint64_t kTexels = 64 * 32, kMips = 2048 + 512 + 128 + 32 + 8 + 2;
  EXPECT_EQ(moved(kFill), 4 * kTexels * 4 + 64) << "mip 0 of four layers and a buffer, no scene depth";
  EXPECT_EQ(moved(kLight), kTexels * 8 + 4 * kMips * 4) << "all mips read, no shadow map";
  EXPECT_EQ(moved(kSum), kTexels * 8 + 2 * kTexels * 4 + 16 * kTexels * 2 + 2 * 8) << "history and a buffer both ways";
  EXPECT_EQ(moved(kScreen), 16 * kTexels * 2 + 64 + 1000 + kTexels * 4 + kTexels * 4) << "cleared targets";
  EXPECT_EQ(moved(kIndirect), 2 * 1000 + kTexels * 4);
  given.targets[0].load = 1;
  given.bindings[kLight][1] = Given::bind(1, TY_SOURCE_IMAGE, kArray, TY_ACCESS_SAMPLED);
  auto loaded = copyLayout(&given.layout);
  EXPECT_EQ(bytesMoved(*loaded, loaded->passes[kScreen], 1000), moved(kScreen) + 1000);
  EXPECT_EQ(bytesMoved(*loaded, loaded->passes[kLight], 1000), moved(kLight)) << "two bindings of one image";
}

TEST(Layout, theCopyOutlivesThePlugin) {
  auto given = std::make_unique<Given>();
  auto layout = copyLayout(&given->layout);
  ASSERT_TRUE(layout);
  std::memset(static_cast<void*>(given.get()), 0xee, offsetof(Given, context));
  EXPECT_EQ(layout->passes[kScreen].name, "screen");
  EXPECT_EQ(layout->passes[kScreen].targets[1].index, static_cast<std::uint32_t>(kUint));
  EXPECT_EQ(layout->passes[kFill].bindings[1].index, static_cast<std::uint32_t>(kArray));
  EXPECT_EQ(layout->passes[kFill].specializations[1].id, 1u);
  EXPECT_EQ(layout->counters->names[1], "skipped: dark");
  EXPECT_EQ(layout->tunables[0].passes[0], "fill");
  EXPECT_EQ(layout->debugViews[1].name, "map");
}

TEST(Layout, theEmptyOneIsTaken) {
  TyLayout empty{};
  empty.struct_size = sizeof empty;
  const auto copy = copyLayout(&empty);
  ASSERT_TRUE(copy);
  EXPECT_TRUE(checkLayout(*copy, {}, {}));
  EXPECT_FALSE(copyLayout(nullptr));
}

struct Case {
  const char* says;
  std::function<void(Given&)> spoil;
};

void expectRefusals(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    Given given;
    c.spoil(given);
    const auto checked = given.check();
    EXPECT_FALSE(checked) << c.says;
    if (checked) continue;
    EXPECT_THAT(checked.error().message, HasSubstr(c.says));
    EXPECT_THAT(checked.error().message, Not(HasSubstr("\n")));
  }
}

TEST(LayoutRefused, arrays) {
  expectRefusals({
      {"images: the array is null", [](Given& g) { g.layout.images = nullptr; }},
      {"passes: there are 4294967295", [](Given& g) { g.layout.pass_count = TY_NONE; }},
      {"images[2]: struct_size", [](Given& g) { g.images[2].struct_size = 0; }},
      {"buffers[0]: struct_size", [](Given& g) { g.buffers[0].struct_size = 3; }},
      {"images[0].name", [](Given& g) { g.images[0].name = nullptr; }},
      {"passes[1].name", [](Given& g) { g.passes[1].name = ""; }},
      {"pass 'fill': shader", [](Given& g) { g.passes[kFill].shader = nullptr; }},
      {"pass 'fill': bindings", [](Given& g) { g.passes[kFill].bindings = nullptr; }},
      {"pass 'fill': specializations", [](Given& g) { g.passes[kFill].specializations = nullptr; }},
      {"counters", [](Given& g) { g.counters.names = nullptr; }},
      {"counters: name 1", [](Given& g) { g.counterNames[1] = nullptr; }},
      {"variants", [](Given& g) { g.tunables[0].variants = nullptr; }},
      {"debug_views[0].doc", [](Given& g) { g.views[0].doc = nullptr; }},
  });
}

TEST(LayoutRefused, images) {
  expectRefusals({
      {"image 'flat': format 0", [](Given& g) { g.images[kFlat].format = 0; }},
      {"image 'flat': format 17", [](Given& g) { g.images[kFlat].format = 17; }},
      {"image 'flat': kind 3", [](Given& g) { g.images[kFlat].kind = 3; }},
      {"image 'flat': is 0x32x1", [](Given& g) { g.images[kFlat].width = 0; }},
      {"image 'flat': is 64x20000x1", [](Given& g) { g.images[kFlat].height = 20000; }},
      {"image 'flat': is 64x32x2", [](Given& g) { g.images[kFlat].depth = 2; }},
      {"image 'array': is 64x32x5000", [](Given& g) { g.images[kArray].depth = 5000; }},
      {"image 'volume': is 4000x32x16", [](Given& g) { g.images[kVolume].width = 4000; }},
      {"image 'array': has 8 mips; its size allows 1 to 7", [](Given& g) { g.images[kArray].mips = 8; }},
      {"image 'array': has 0 mips", [](Given& g) { g.images[kArray].mips = 0; }},
      {"unknown flags", [](Given& g) { g.images[kFlat].flags = 2; }},
      {"3D depth image", [](Given& g) { g.images[kVolume].format = TY_FORMAT_D32_FLOAT; }},
      {"'flat': names two", [](Given& g) { g.images[kArray].name = "flat"; }},
      {"'flat': names two", [](Given& g) { g.buffers[0].name = "flat"; }},
      {"buffer 'arguments': is 0 bytes", [](Given& g) { g.buffers[0].size = 0; }},
      {"buffer 'arguments': is 6 bytes", [](Given& g) { g.buffers[0].size = 6; }},
      {"buffer 'arguments': is 18446744073709551612", [](Given& g) { g.buffers[0].size = ~0ull - 3; }},
      {"uniform block 'frame': is 20000", [](Given& g) { g.uniforms[0].size = 20000; }},
      {"uniform block 'frame': is 0", [](Given& g) { g.uniforms[0].size = 0; }},
      {"uniform block 'frame'", [](Given& g) { g.uniforms[0].per_light = 2; }},
  });
}

TEST(LayoutRefused, bindings) {
  expectRefusals({
      {"pass 'fill': binding 0 is given twice", [](Given& g) { g.bindings[kFill][1].binding = 0; }},
      {"image 6; there are 6", [](Given& g) { g.bindings[kFill][1].index = kImageCount; }},
      {"buffer 4294967295", [](Given& g) { g.bindings[kFill][2].index = TY_NONE; }},
      {"uniform block 2", [](Given& g) { g.bindings[kFill][3].index = 2; }},
      {"index 1; this source has only index 0", [](Given& g) { g.bindings[kFill][0].index = 1; }},
      {"unknown source 8", [](Given& g) { g.bindings[kFill][0].source = 8; }},
      {"unknown access 5", [](Given& g) { g.bindings[kFill][0].access = 5; }},
      {"unknown sampler 6", [](Given& g) { g.bindings[kFill][0].sampler = 6; }},
      {"mixes uniform", [](Given& g) { g.bindings[kFill][3].access = TY_ACCESS_SAMPLED; }},
      {"mixes uniform", [](Given& g) { g.bindings[kFill][1].access = TY_ACCESS_UNIFORM; }},
      {"samples a buffer", [](Given& g) { g.bindings[kFill][2].access = TY_ACCESS_SAMPLED; }},
      {"per-light uniform", [](Given& g) { g.bindings[kFill][3].index = 1; }},
      {"shadow map in a pass that is not per light",
       [](Given& g) { g.bindings[kFill][0].source = TY_SOURCE_SHADOW_MAP; }},
      {"part of a shadow map", [](Given& g) { g.bindings[kLight][0].layer_count = 1; }},
      {"depth image; sample it", [](Given& g) { g.bindings[kFill][0].access = TY_ACCESS_STORAGE_READ; }},
      {"linearly", [](Given& g) { g.bindings[kFill][0].sampler = TY_SAMPLER_LINEAR_CLAMP; }},
      {"mips beyond the image's 6", [](Given& g) { g.bindings[kLight][3].base_mip = 6; }},
      {"mips beyond the image's 6",
       [](Given& g) { g.bindings[kLight][3].base_mip = 2, g.bindings[kLight][3].mip_count = 5; }},
      {"layers beyond the image's 4", [](Given& g) { g.bindings[kLight][3].base_layer = 4; }},
      {"layers beyond the image's 4",
       [](Given& g) { g.bindings[kLight][3].base_layer = 1, g.bindings[kLight][3].layer_count = TY_NONE; }},
      {"several mips", [](Given& g) { g.bindings[kFill][1].mip_count = 2; }},
      {"only compute passes", [](Given& g) { g.bindings[kScreen][1].access = TY_ACCESS_STORAGE_READ_WRITE; }},
      {"only compute passes", [](Given& g) { g.bindings[kScreen][0].access = TY_ACCESS_STORAGE_READ; }},
      {"two ways", [](Given& g) { g.bindings[kLight][3] = Given::bind(3, TY_SOURCE_IMAGE, kFlat, TY_ACCESS_SAMPLED); }},
      {"bindings 1 and 3 use image 'array' in two ways at once and their mips and layers overlap",
       [](Given& g) {
         g.bindings[kLight][1] = Given::bind(1, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_WRITE);
         g.bindings[kLight][1].base_mip = 2;
         g.bindings[kLight][3].mip_count = 3;
       }},
      {"bindings 1 and 3 use image 'array' in two ways at once and their mips and layers overlap",
       [](Given& g) {
         g.bindings[kLight][1] = Given::bind(1, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_READ_WRITE);
         g.bindings[kLight][1].base_mip = 5;  // all mips from base_mip 0 are sampled
       }},
      {"two ways at once and their mips and layers overlap",
       [](Given& g) {  // two stores to one layer
         g.bindings[kLight][2] = Given::bind(2, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_WRITE);
         g.bindings[kLight][3] = Given::bind(3, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_WRITE);
         g.bindings[kLight][2].base_layer = g.bindings[kLight][3].base_layer = 1;
       }},
      {"two ways at once; read it one way",
       [](Given& g) {
         g.bindings[kLight][2] = Given::bind(2, TY_SOURCE_IMAGE, kArray, TY_ACCESS_STORAGE_READ);
         g.bindings[kLight][2].base_mip = 1;
         g.bindings[kLight][3].mip_count = 1;
       }},
      {"two ways",
       [](Given& g) { g.bindings[kLight][3] = Given::bind(3, TY_SOURCE_IMAGE, kFlat, TY_ACCESS_STORAGE_WRITE); }},
      {"two ways",
       [](Given& g) { g.bindings[kIndirect][1] = Given::bind(1, TY_SOURCE_BUFFER, 0, TY_ACCESS_STORAGE_READ); }},
      {"two ways", [](Given& g) { g.bindings[kScreen][0] = Given::bind(0, TY_SOURCE_OUTPUT, 0, TY_ACCESS_SAMPLED); }},
  });
}

TEST(LayoutRefused, passes) {
  expectRefusals({
      {"shadow volumes are not built", [](Given& g) { g.passes[kFill].kind = TY_PASS_SHADOW_VOLUMES; }},
      {"kind 5", [](Given& g) { g.passes[kFill].kind = 5; }},
      {"groups[1] is 0", [](Given& g) { g.passes[kFill].groups[1] = 0; }},
      {"groups[2] is 65536", [](Given& g) { g.passes[kFill].groups[2] = 65536; }},
      {"per_light", [](Given& g) { g.passes[kFill].per_light = 2; }},
      {"light_kinds", [](Given& g) { g.passes[kLight].light_kinds = 8; }},
      {"ending in .comp", [](Given& g) { g.passes[kFill].shader = "fill.frag"; }},
      {"ending in .frag", [](Given& g) { g.passes[kScreen].shader = "screen.comp"; }},
      {"no plain file name", [](Given& g) { g.passes[kFill].shader = "../../etc/fill.comp"; }},
      {"no plain file name", [](Given& g) { g.passes[kFill].shader = ".comp"; }},
      {"constant 0 is given twice", [](Given& g) { g.constants[1].id = 0; }},
      {"compute pass with targets",
       [](Given& g) { g.passes[kFill].targets = g.targets, g.passes[kFill].target_count = 1; }},
      {"indirect buffer 2", [](Given& g) { g.passes[kIndirect].indirect_buffer = 2; }},
      {"indirect_offset 56", [](Given& g) { g.passes[kIndirect].indirect_offset = 56; }},
      {"indirect_offset 2", [](Given& g) { g.passes[kIndirect].indirect_offset = 2; }},
      {"indirect_offset 18446744073709551608", [](Given& g) { g.passes[kIndirect].indirect_offset = ~7ull; }},
      {"no target", [](Given& g) { g.passes[kScreen].target_count = 0, g.passes[kScreen].depth_target = nullptr; }},
      {"differ in size", [](Given& g) { g.images[kUint].width = 32; }},
      {"differ in size", [](Given& g) { g.context.width = 65; }},
      {"target image 9", [](Given& g) { g.targets[1].index = 9; }},
      {"neither an image nor", [](Given& g) { g.targets[0].source = TY_SOURCE_SCENE_DEPTH; }},
      {"3D image", [](Given& g) { g.targets[1].index = kVolume; }},
      {"colour target is a depth image", [](Given& g) { g.targets[1].index = kDepth; }},
      {"no depth image", [](Given& g) { g.screenDepth.index = kFlat; }},
      {"mip or layer", [](Given& g) { g.targets[1].mip = 1; }},
      {"mip or layer", [](Given& g) { g.targets[1].layer = 1; }},
      {"load is 0 or 1", [](Given& g) { g.targets[0].load = 2; }},
      {"load is 0 or 1", [](Given& g) { g.targets[0].blend = 4; }},
      {"integer format", [](Given& g) { g.targets[1].blend = TY_BLEND_ADD; }},
      {"not finite", [](Given& g) { g.targets[0].clear[2] = std::numeric_limits<float>::quiet_NaN(); }},
      {"outside [0, 1]", [](Given& g) { g.depth.clear[0] = 2; }},
      {"depth_compare", [](Given& g) { g.passes[kScreen].depth_compare = 3; }},
      {"caster_uniform 2", [](Given& g) { g.passes[kCasters].caster_uniform = 2; }},
      {"starts with a mat4", [](Given& g) { g.uniforms[1].size = 60; }},
      {"depth only", [](Given& g) { g.passes[kCasters].targets = g.targets, g.passes[kCasters].target_count = 1; }},
  });
}

TEST(Layout, aMomentShadowMapIsBoundWhole) {
  const auto moments = [](Given& g) {
    g.context.shadowMoments = TY_FORMAT_RGBA16_UNORM;
    g.bindings[kLight][0] =
        Given::bind(0, TY_SOURCE_SHADOW_MOMENTS, 0, TY_ACCESS_SAMPLED, TY_SAMPLER_LINEAR_MIPMAP_CLAMP);
    g.views[1].source = TY_SOURCE_SHADOW_MOMENTS;
  };
  Given good;
  moments(good);
  EXPECT_TRUE(good.check()) << good.check().error().message;
  expectRefusals({
      {"which this renderer does not make", [&](Given& g) { moments(g), g.context.shadowMoments = TY_FORMAT_UNKNOWN; }},
      {"not per light", [&](Given& g) { moments(g), g.passes[kLight].per_light = 0; }},
      {"moment shadow map; sample it",
       [&](Given& g) { moments(g), g.bindings[kLight][0].access = TY_ACCESS_STORAGE_READ; }},
      {"some mips", [&](Given& g) { moments(g), g.bindings[kLight][0].base_mip = 1; }},
      {"some mips", [&](Given& g) { moments(g), g.bindings[kLight][0].mip_count = 1; }},
      {"a part of a shadow map", [&](Given& g) { moments(g), g.bindings[kLight][0].layer_count = 1; }},
      {"only index 0", [&](Given& g) { moments(g), g.bindings[kLight][0].index = 1; }},
      {"mip or layer", [&](Given& g) { moments(g), g.views[1].layer = 6; }},
      {"neither an image nor", [&](Given& g) { moments(g), g.targets[0].source = TY_SOURCE_SHADOW_MOMENTS; }},
  });
}

TEST(Layout, aLightsCookieIsBoundWhole) {
  const auto cookie = [](Given& g) {
    g.context.cookies = true;
    g.bindings[kLight][0] =
        Given::bind(0, TY_SOURCE_LIGHT_COOKIE, 0, TY_ACCESS_SAMPLED, TY_SAMPLER_LINEAR_MIPMAP_REPEAT);
  };
  Given good;
  cookie(good);
  EXPECT_TRUE(good.check()) << good.check().error().message;
  expectRefusals({
      {"which this renderer does not offer", [&](Given& g) { cookie(g), g.context.cookies = false; }},
      {"not per light", [&](Given& g) { cookie(g), g.passes[kLight].per_light = 0; }},
      {"light's cookie; sample it",
       [&](Given& g) { cookie(g), g.bindings[kLight][0].access = TY_ACCESS_STORAGE_READ; }},
      {"a part of a light's cookie", [&](Given& g) { cookie(g), g.bindings[kLight][0].base_mip = 1; }},
      {"a part of a light's cookie", [&](Given& g) { cookie(g), g.bindings[kLight][0].layer_count = 1; }},
      {"only index 0", [&](Given& g) { cookie(g), g.bindings[kLight][0].index = 1; }},
      {"unknown sampler 6", [&](Given& g) { cookie(g), g.bindings[kLight][0].sampler = 6; }},
      {"neither an image nor", [&](Given& g) { cookie(g), g.targets[0].source = TY_SOURCE_LIGHT_COOKIE; }},
      {"its source is", [&](Given& g) { cookie(g), g.views[1].source = TY_SOURCE_LIGHT_COOKIE; }},
  });
}

TEST(LayoutRefused, readingWhatNobodyWrote) {
  expectRefusals({
      {"pass 'sum': reads image 'flat'", [](Given& g) { std::swap(g.passes[kLight], g.passes[kSum]); }},
      {"pass 'light': reads image 'array'", [](Given& g) { g.bindings[kFill][1].index = kVolume; }},
      {"reads the output", [](Given& g) { g.targets[0].source = TY_SOURCE_IMAGE, g.targets[0].index = kFlat; }},
      {"reads the output", [](Given& g) { g.targets[0].load = 1; }},
      {"reads image 'history'", [](Given& g) { g.images[kHistory].flags = 0; }},
      {"pass 'sum': reads buffer 'counted'", [](Given& g) { g.layout.counters = nullptr; }},
      {"pass 'screen': reads image 'volume'", [](Given& g) { g.context.lightKinds = {TY_LIGHT_SPOT}; }},
      {"no pass writes the output", [](Given& g) { g.layout.pass_count = 3; }},
  });
}

TEST(LayoutRefused, viewsCountersTunables) {
  expectRefusals({
      {"debug view 'map': appears twice", [](Given& g) { g.views[0].name = "map"; }},
      {"debug view 'map': has the role 3", [](Given& g) { g.views[0].role = g.views[1].role = TY_VIEW_ROW_PLACE; }},
      {"debug view 'flat': image 6", [](Given& g) { g.views[0].index = 6; }},
      {"3D or integer", [](Given& g) { g.views[0].index = kVolume; }},
      {"3D or integer", [](Given& g) { g.views[0].index = kUint; }},
      {"channel", [](Given& g) { g.views[0].channel = 5; }},
      {"channel", [](Given& g) { g.views[0].high = 0; }},
      {"mip or layer", [](Given& g) { g.views[0].layer = 1; }},
      {"its source is", [](Given& g) { g.views[0].source = TY_SOURCE_BUFFER; }},
      {"counters: buffer 2", [](Given& g) { g.counters.buffer = 2; }},
      {"counters: 2 names, but buffer 'counted' holds 1", [](Given& g) { g.buffers[1].size = 4; }},
      {"must be transient", [](Given& g) { g.buffers[1].flags = TY_RESOURCE_HISTORY; }},
      {"tunable of parameter 1", [](Given& g) { g.tunables[0].parameter = 1; }},
      {"tunable of parameter 9", [](Given& g) { g.tunables[0].parameter = 9; }},
      {"at least one variant", [](Given& g) { g.tunables[0].variant_count = 0; }},
      {"automatic value itself", [](Given& g) { g.variants[1] = 0; }},
      {"the pass 'fuel'", [](Given& g) { g.timed[0] = "fuel"; }},
  });
}

TEST(Passes, lightsTakeTurnsWithinAGroup) {
  Layout layout;
  for (const int perLight : {0, 1, 1, 0, 1}) {
    layout.passes.emplace_back();
    layout.passes.back().d.per_light = static_cast<std::uint32_t>(perLight);
  }
  layout.passes[2].d.light_kinds = 1u << TY_LIGHT_SPOT;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
  for (const PassRun& run : expandPasses(layout, {TY_LIGHT_DIRECTIONAL, TY_LIGHT_SPOT}))
    runs.emplace_back(run.pass, run.light);
  using P = std::pair<std::uint32_t, std::uint32_t>;
  EXPECT_THAT(runs, ElementsAre(P{0, TY_NONE}, P{1, 0}, P{1, 1}, P{2, 1}, P{3, TY_NONE}, P{4, 0}, P{4, 1}));
  EXPECT_EQ(expandPasses(layout, {}).size(), 2u);
}

TEST(Formats, bytes) {
  EXPECT_EQ(formatBytes(TY_FORMAT_UNKNOWN), 0u);
  EXPECT_EQ(formatBytes(17), 0u);
  TyImage image{sizeof(TyImage), TY_IMAGE_2D_ARRAY, nullptr, TY_FORMAT_RGBA8_UNORM, 4, 4, 3, 3, 0};
  EXPECT_EQ(imageBytes(image), 4u * 3 * (16 + 4 + 1));
  image.kind = TY_IMAGE_3D;
  EXPECT_EQ(imageBytes(image), 4u * (48 + 4 + 1));
}

}  // namespace
}  // namespace tyndall::host
