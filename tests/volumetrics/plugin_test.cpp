// The plugin through its exported tables, without a GPU: parameters, techniques, layouts, prepare.
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "params/table.hpp"
#include "stages/rectified.h"
#include "techniques/ray_march/ray_march_blocks.h"
#include "tyndall/plugin.h"

extern "C" const TyPlugin tyndall_plugin;

namespace {

/// Ids of the techniques that the plugin registers.
std::vector<std::string> built() {
  std::uint32_t count = 0, selector = 0;
  const TyTechnique* list = tyndall_plugin.techniques(&count, &selector);
  std::vector<std::string> ids;
  for (std::uint32_t i = 0; i < count; ++i) ids.push_back(list[i].id);
  return ids;
}

struct Fixture : testing::Test {
  std::uint32_t count = 0;
  const TyParameter* table = tyndall_plugin.parameters(&count);
  std::vector<double> values;
  std::vector<std::uint32_t> kinds{TY_LIGHT_DIRECTIONAL};
  std::vector<std::uint32_t> sizes{1024};
  TyInstance* instance = tyndall_plugin.create();
  TyDevice device{};

  Fixture() {
    for (std::uint32_t i = 0; i < count; ++i) values.push_back(table[i].default_value);
    device.struct_size = sizeof(device);
    device.max_push_descriptors = 32;
  }
  ~Fixture() override { tyndall_plugin.destroy(instance); }

  std::uint32_t index(const std::string& id) const {
    for (std::uint32_t i = 0; i < count; ++i)
      if (id == table[i].id) return i;
    ADD_FAILURE() << "no parameter " << id;
    return 0;
  }
  void set(const std::string& id, const std::string& choice) {
    const TyParameter& p = table[index(id)];
    for (std::uint32_t c = 0; c < p.choice_count; ++c)
      if (choice == p.choices[c]) return void(values[index(id)] = c);
    FAIL() << id << ' ' << choice;
  }
  const TyLayout* layout() {
    TyStructure s{};
    s.struct_size = sizeof(s);
    s.width = 320;
    s.height = 180;
    s.light_count = static_cast<std::uint32_t>(kinds.size());
    sizes.resize(kinds.size(), 1024);
    s.light_kinds = kinds.data();
    s.shadow_sizes = sizes.data();
    s.values = values.data();
    s.value_count = count;
    return tyndall_plugin.layout(instance, &device, &s);
  }
};

}  // namespace

TEST_F(Fixture, TableIsWellFormed) {
  std::set<std::string> ids;
  for (std::uint32_t i = 0; i < count; ++i) {
    const TyParameter& p = table[i];
    EXPECT_EQ(p.struct_size, sizeof(TyParameter));
    EXPECT_TRUE(ids.insert(p.id).second) << p.id;
    EXPECT_GT(std::strlen(p.doc), 10u) << p.id;
    if (p.type == TY_PARAMETER_ENUM) {
      ASSERT_GT(p.choice_count, 1u) << p.id;
      EXPECT_FALSE(p.unbuilt >> static_cast<int>(p.default_value) & 1) << p.id << ": the default must be built";
    } else if (p.type != TY_PARAMETER_BOOL) {
      EXPECT_LE(p.min_value, p.default_value) << p.id;
      EXPECT_GE(p.max_value, p.default_value) << p.id;
      EXPECT_LE(p.built_min, p.default_value) << p.id;
      EXPECT_GE(p.built_max, p.default_value) << p.id;
    } else {
      EXPECT_FALSE(p.unbuilt >> static_cast<int>(p.default_value) & 1) << p.id;
    }
  }
}

TEST_F(Fixture, TechniquesReadKnownParameters) {
  std::uint32_t techniques = 0, selector = 0;
  const TyTechnique* list = tyndall_plugin.techniques(&techniques, &selector);
  EXPECT_STREQ(table[selector].id, "volumetrics.technique");
  std::set<std::string> names;
  for (std::uint32_t i = 0; i < techniques; ++i) {
    names.insert(list[i].id);
    EXPECT_GT(list[i].read_count, 5u);
    for (std::uint32_t r = 0; r < list[i].read_count; ++r) index(list[i].reads[r]);
  }
  for (const char* known : {"exact", "fourier", "min_max", "moments4", "moments6", "ray_march"})
    EXPECT_TRUE(names.contains(known)) << known;
  const TyParameter& choice = table[selector];
  EXPECT_STREQ(choice.choices[static_cast<std::size_t>(choice.default_value)], "exact");
}

// Pure: the same structure gives the same layout, and parameters that are not structural change nothing.
TEST_F(Fixture, LayoutDependsOnStructuralParametersOnly) {
  const auto fingerprint = [&](const TyLayout* l) {
    std::string text;
    for (std::uint32_t i = 0; i < l->image_count; ++i)
      text += std::string(l->images[i].name) + std::to_string(l->images[i].format) + "," +
              std::to_string(l->images[i].width) + "," + std::to_string(l->images[i].height) + "," +
              std::to_string(l->images[i].depth) + ";";
    for (std::uint32_t i = 0; i < l->pass_count; ++i) {
      const TyPass& p = l->passes[i];
      text += std::string(p.name) + p.shader + std::to_string(p.groups[0]) + "x" + std::to_string(p.groups[1]);
      for (std::uint32_t j = 0; j < p.specialization_count; ++j)
        text += ":" + std::to_string(p.specializations[j].id) + "=" + std::to_string(p.specializations[j].value);
      for (std::uint32_t j = 0; j < p.binding_count; ++j)
        text += "|" + std::to_string(p.bindings[j].binding) + "," + std::to_string(p.bindings[j].source) + "," +
                std::to_string(p.bindings[j].index) + "," + std::to_string(p.bindings[j].access);
    }
    return text;
  };
  for (const std::string& technique : built()) {
    set("volumetrics.technique", technique);
    const std::string before = fingerprint(layout());
    EXPECT_EQ(fingerprint(layout()), before);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (table[i].flags & TY_PARAMETER_STRUCTURAL) continue;
      const double old = values[i];
      values[i] =
          table[i].type == TY_PARAMETER_FLOAT ? (table[i].min_value + table[i].max_value) / 2 : table[i].max_value;
      EXPECT_EQ(fingerprint(layout()), before) << table[i].id;
      values[i] = old;
    }
  }
  set("volumetrics.technique", "moments6");
  const std::string before = fingerprint(layout());
  for (const auto& [id, value] : std::map<std::string, double>{{"volumetrics.columns", 512},
                                                               {"volumetrics.slices", 256},
                                                               {"volumetrics.reference_rays", 2},
                                                               {"volumetrics.prefix_bounds", 0},
                                                               {"volumetrics.precision", 2},
                                                               {"volumetrics.row_filter", 0},
                                                               {"volumetrics.prefix_scheme", 2}}) {
    const double old = values[index(id)];
    values[index(id)] = value;
    EXPECT_NE(fingerprint(layout()), before) << id;
    values[index(id)] = old;
  }
}

TEST_F(Fixture, IndicesAndPassesAreSound) {
  for (const std::string& technique : built())
    for (std::size_t lights : {0u, 1u, 3u})
      for (double precision : {0.0, 1.0, 2.0}) {
        set("volumetrics.technique", technique);
        values[index("volumetrics.precision")] = precision;
        kinds.assign(lights, TY_LIGHT_DIRECTIONAL);
        const TyLayout* l = layout();
        ASSERT_NE(l, nullptr);
        ASSERT_GT(l->pass_count, 0u);
        bool writesOutput = false;
        for (std::uint32_t i = 0; i < l->pass_count; ++i) {
          const TyPass& p = l->passes[i];
          std::set<std::uint32_t> slots;
          for (std::uint32_t j = 0; j < p.binding_count; ++j) {
            const TyBinding& b = p.bindings[j];
            EXPECT_TRUE(slots.insert(b.binding).second);
            const std::map<std::uint32_t, std::uint32_t> limits = {{TY_SOURCE_IMAGE, l->image_count},
                                                                   {TY_SOURCE_BUFFER, l->buffer_count},
                                                                   {TY_SOURCE_UNIFORM, l->uniform_count}};
            if (const auto limit = limits.find(b.source); limit != limits.end()) {
              EXPECT_LT(b.index, limit->second);
            }
            if (b.source == TY_SOURCE_OUTPUT) {
              // Before anything is added, something must have been written.
              EXPECT_TRUE(writesOutput || b.access == TY_ACCESS_STORAGE_WRITE) << technique << lights;
              writesOutput = true;
            }
          }
        }
        EXPECT_TRUE(writesOutput);
      }
}

TEST_F(Fixture, NothingToDoIsAnEmptyLayout) {
  set("volumetrics.technique", "none");
  EXPECT_EQ(layout()->pass_count, 0u);
  set("volumetrics.technique", "moments6");
  values[index("volumetrics.enabled")] = 0;
  EXPECT_EQ(layout()->pass_count, 0u);
}

TEST_F(Fixture, AnUnbuiltTechniqueIsRefused) {
  set("volumetrics.technique", "froxel");
  EXPECT_EQ(layout(), nullptr);
}

TEST_F(Fixture, PrepareFillsTheBlocks) {
  set("volumetrics.technique", "moments4");
  set("volumetrics.precision", "compact");
  values[index("medium.sigma_t")] = 0.125;
  const TyLayout* l = layout();
  std::vector<std::vector<std::uint8_t>> memory;
  std::vector<std::uint8_t*> data;
  std::vector<std::uint32_t> stride;
  for (std::uint32_t i = 0; i < l->uniform_count; ++i) {
    EXPECT_LE(l->uniforms[i].size, 16384u);
    memory.emplace_back(l->uniforms[i].size, std::uint8_t{0xcd});
    data.push_back(memory.back().data());
    stride.push_back(l->uniforms[i].size);
  }
  TyView view{};
  view.width = 320;
  view.height = 180;
  view.znear = 0.1f;
  view.zfar = 100;
  view.clip_from_view[0] = view.clip_from_view[5] = 1;
  for (int i = 0; i < 4; ++i) view.world_from_view[i * 5] = 1;
  TyLight light{};
  light.direction[1] = -1;
  light.radiance[0] = 7;
  light.shadow_size = 1024;
  for (int i = 0; i < 4; ++i) light.shadow_clip_from_world[0][i * 5] = 1;
  TyFrame frame{};
  frame.view = &view;
  frame.lights = &light;
  frame.light_count = 1;
  frame.values = values.data();
  frame.value_count = count;
  TyUniformData out{sizeof(TyUniformData), l->uniform_count, data.data(), stride.data()};
  ASSERT_TRUE(tyndall_plugin.prepare(instance, &frame, &out));
  tyndall::shared::RectifiedBlock block;
  std::memcpy(&block, data[0], sizeof(block));
  EXPECT_FLOAT_EQ(block.rays.sigma_t, 0.125f);
  EXPECT_FLOAT_EQ(block.momentBias, 6e-5f);  // section 2.5
  EXPECT_FLOAT_EQ(block.biasTarget, 0.628f);
  tyndall::shared::RectifiedLightBlock sun;
  std::memcpy(&sun, data[1], sizeof(sun));
  EXPECT_FLOAT_EQ(sun.sun.irradiance.x, 7);
  EXPECT_FLOAT_EQ(sun.sun.towards.y, 1);
  EXPECT_EQ(sun.map.columns, 1024u);
}
