// What filtered resampling asks of the host, and what is said where the host has no moment shadow maps.
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tyndall/plugin.h"

extern "C" const TyPlugin tyndall_plugin;

namespace {

struct FilteredResampling : testing::Test {
  static std::vector<std::string>& log() {
    static std::vector<std::string> lines;
    return lines;
  }
  TyHost host{sizeof(TyHost),
              TY_ABI_VERSION,
              "test",
              nullptr,
              [](void*, std::uint32_t level, const char* line) {
                if (level >= TY_LOG_WARNING) log().emplace_back(line);
              },
              [](void*, const char*) -> const void* { return nullptr; }};
  std::uint32_t count = 0;
  const TyParameter* table = nullptr;
  std::vector<double> values;
  TyInstance* instance = nullptr;

  void SetUp() override {
    log().clear();
    ASSERT_TRUE(tyndall_plugin.init(&host));
    instance = tyndall_plugin.create();
    table = tyndall_plugin.parameters(&count);
    for (std::uint32_t i = 0; i < count; ++i) values.push_back(table[i].default_value);
    value("volumetrics.filtered_resampling") = 1;
  }
  void TearDown() override {
    tyndall_plugin.destroy(instance);
    tyndall_plugin.shutdown();
  }
  double& value(const std::string& id) {
    for (std::uint32_t i = 0; i < count; ++i)
      if (id == table[i].id) return values[i];
    throw std::runtime_error("no parameter " + id);
  }
  void technique(const std::string& name) {
    const TyParameter* p = table;
    while (std::strcmp(p->id, "volumetrics.technique") != 0) ++p;
    for (std::uint32_t c = 0; c < p->choice_count; ++c)
      if (name == p->choices[c]) value("volumetrics.technique") = c;
  }
  /// The pass "rectify" of the layout for one sun.
  const TyPass& rectify(std::uint32_t momentsFormat, std::uint32_t structSize = sizeof(TyStructure)) {
    static const std::uint32_t kind = TY_LIGHT_DIRECTIONAL, size = 1024;
    TyDevice device{};
    device.struct_size = sizeof device;
    device.max_push_descriptors = 32;
    device.max_workgroup_invocations = 1024;
    device.max_shared_memory = 32768;
    TyStructure s{};
    s.struct_size = structSize;
    s.width = 320;
    s.height = 180;
    s.light_count = 1;
    s.light_kinds = &kind;
    s.shadow_sizes = &size;
    s.values = values.data();
    s.value_count = count;
    s.shadow_moments_format = momentsFormat;
    const TyLayout* layout = tyndall_plugin.layout(instance, &device, &s);
    for (std::uint32_t i = 0; i < layout->pass_count; ++i)
      if (std::strcmp(layout->passes[i].name, "rectify") == 0) return layout->passes[i];
    throw std::runtime_error("no pass 'rectify'");
  }
  static std::uint32_t constant(const TyPass& pass, std::uint32_t id) {
    for (std::uint32_t i = 0; i < pass.specialization_count; ++i)
      if (pass.specializations[i].id == id) return pass.specializations[i].value;
    return TY_NONE;
  }
  static bool binds(const TyPass& pass, std::uint32_t source) {
    for (std::uint32_t i = 0; i < pass.binding_count; ++i)
      if (pass.bindings[i].source == source) return true;
    return false;
  }
};

TEST_F(FilteredResampling, ReadsTheMomentsInTheFormatThatTheHostHas) {
  for (const char* name : {"fourier", "moments4", "moments6"}) {
    technique(name);
    for (const auto& [format, quantised] : {std::pair{TY_FORMAT_RGBA16_UNORM, 1u}, {TY_FORMAT_RGBA32_FLOAT, 0u}}) {
      const TyPass& pass = rectify(format);
      EXPECT_TRUE(binds(pass, TY_SOURCE_SHADOW_MOMENTS)) << name;
      EXPECT_FALSE(binds(pass, TY_SOURCE_SHADOW_MAP)) << name;
      EXPECT_EQ(constant(pass, 0), 1u) << name;
      EXPECT_EQ(constant(pass, 1), quantised) << name;
    }
  }
  value("volumetrics.filtered_resampling") = 0;
  EXPECT_TRUE(binds(rectify(TY_FORMAT_RGBA16_UNORM), TY_SOURCE_SHADOW_MAP));
  value("volumetrics.filtered_resampling") = 1;
  technique("min_max");  // bounds of trees must not be means
  EXPECT_TRUE(binds(rectify(TY_FORMAT_RGBA16_UNORM), TY_SOURCE_SHADOW_MAP));
  EXPECT_TRUE(log().empty());
}

TEST_F(FilteredResampling, IsNeverLeftOutInSilence) {
  technique("moments6");
  EXPECT_TRUE(binds(rectify(TY_FORMAT_UNKNOWN), TY_SOURCE_SHADOW_MAP));
  ASSERT_EQ(log().size(), 1u);
  EXPECT_NE(log()[0].find("volumetrics.filtered_resampling: this host makes no moment shadow maps"), std::string::npos);
  rectify(TY_FORMAT_UNKNOWN);
  EXPECT_EQ(log().size(), 1u) << "said once";
  rectify(TY_FORMAT_RGBA16_UNORM);
  // A host of version 1.0 knows nothing of the field: what stands behind its struct must not be read.
  const TyPass& older = rectify(TY_FORMAT_RGBA16_UNORM, offsetof(TyStructure, shadow_moments_format));
  EXPECT_TRUE(binds(older, TY_SOURCE_SHADOW_MAP));
  EXPECT_EQ(constant(older, 0), 0u);
  EXPECT_EQ(log().size(), 2u) << "said again after a layout that had them";
}

}  // namespace
