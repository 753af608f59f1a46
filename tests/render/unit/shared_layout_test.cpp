// The structs of shaders/shared have the same offsets in C++ and in the compiled shaders.
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spirv_cross_c.h>

#include "shared/light.h"
#include "shared/surface.h"
#include "shared/view.h"

namespace tyndall {
namespace {

using Offsets = std::map<std::string, std::size_t>;

// Member offsets (and "sizeof") of the struct called `name` in a shader, wherever a block uses it.
Offsets reflect(const std::string& shader, const std::string& name) {
  std::ifstream file(std::string(TYNDALL_BIN_DIR) + "/shaders/" + shader + ".spv", std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
  EXPECT_FALSE(bytes.empty()) << shader;
  std::vector<SpvId> words(bytes.size() / 4);
  std::copy(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(words.size() * 4),
            reinterpret_cast<char*>(words.data()));

  Offsets offsets;
  spvc_context context = nullptr;
  EXPECT_EQ(spvc_context_create(&context), SPVC_SUCCESS);
  spvc_parsed_ir ir = nullptr;
  spvc_compiler compiler = nullptr;
  spvc_resources resources = nullptr;
  EXPECT_EQ(spvc_context_parse_spirv(context, words.data(), words.size(), &ir), SPVC_SUCCESS);
  EXPECT_EQ(spvc_context_create_compiler(context, SPVC_BACKEND_NONE, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler),
            SPVC_SUCCESS);
  EXPECT_EQ(spvc_compiler_create_shader_resources(compiler, &resources), SPVC_SUCCESS);
  for (const spvc_resource_type kind : {SPVC_RESOURCE_TYPE_UNIFORM_BUFFER, SPVC_RESOURCE_TYPE_STORAGE_BUFFER}) {
    const spvc_reflected_resource* list = nullptr;
    std::size_t count = 0;
    spvc_resources_get_resource_list_for_type(resources, kind, &list, &count);
    for (std::size_t i = 0; i < count; ++i) {
      const spvc_type block = spvc_compiler_get_type_handle(compiler, list[i].base_type_id);
      const spvc_type_id memberId =
          spvc_type_get_base_type_id(spvc_compiler_get_type_handle(compiler, spvc_type_get_member_type(block, 0)));
      if (name != spvc_compiler_get_name(compiler, memberId)) continue;
      const spvc_type type = spvc_compiler_get_type_handle(compiler, memberId);
      for (unsigned m = 0; m < spvc_type_get_num_member_types(type); ++m) {
        unsigned offset = 0;
        spvc_compiler_type_struct_member_offset(compiler, type, m, &offset);
        offsets[spvc_compiler_get_member_name(compiler, memberId, m)] = offset;
      }
      std::size_t size = 0;
      spvc_compiler_get_declared_struct_size(compiler, type, &size);
      offsets["sizeof"] = size;
    }
  }
  spvc_context_destroy(context);
  return offsets;
}

#define TY_MEMBER(type, member) \
  { #member, offsetof(shared::type, member) }

TEST(SharedLayout, View) {
  EXPECT_EQ(reflect("lighting.frag", "ViewBlock"), (Offsets{TY_MEMBER(ViewBlock, viewFromWorld),
                                                            TY_MEMBER(ViewBlock, worldFromView),
                                                            TY_MEMBER(ViewBlock, clipFromView),
                                                            TY_MEMBER(ViewBlock, viewFromClip),
                                                            TY_MEMBER(ViewBlock, clipFromWorld),
                                                            TY_MEMBER(ViewBlock, eye),
                                                            TY_MEMBER(ViewBlock, znear),
                                                            TY_MEMBER(ViewBlock, size),
                                                            TY_MEMBER(ViewBlock, zfar),
                                                            TY_MEMBER(ViewBlock, seconds),
                                                            TY_MEMBER(ViewBlock, skyZenith),
                                                            TY_MEMBER(ViewBlock, skyHorizon),
                                                            TY_MEMBER(ViewBlock, ground),
                                                            TY_MEMBER(ViewBlock, towardsSun),
                                                            TY_MEMBER(ViewBlock, sunIrradiance),
                                                            {"sizeof", sizeof(shared::ViewBlock)}}));
}

TEST(SharedLayout, Light) {
  static_assert(sizeof(shared::LightCore) == 52, "nothing but four-byte members: no padding in either language");
  EXPECT_EQ(reflect("lighting.frag", "LightBlock"), (Offsets{TY_MEMBER(LightBlock, core),
                                                             TY_MEMBER(LightBlock, texelSize),
                                                             TY_MEMBER(LightBlock, shadowSize),
                                                             TY_MEMBER(LightBlock, depthCurve),
                                                             TY_MEMBER(LightBlock, clipFromWorld),
                                                             TY_MEMBER(LightBlock, cookie),
                                                             TY_MEMBER(LightBlock, unused),
                                                             {"sizeof", sizeof(shared::LightBlock)}}));
}

TEST(SharedLayout, Surface) {
  EXPECT_EQ(reflect("gbuffer.frag", "MaterialBlock"), (Offsets{TY_MEMBER(MaterialBlock, baseColor),
                                                               TY_MEMBER(MaterialBlock, emissive),
                                                               TY_MEMBER(MaterialBlock, metallic),
                                                               TY_MEMBER(MaterialBlock, roughness),
                                                               TY_MEMBER(MaterialBlock, normalScale),
                                                               TY_MEMBER(MaterialBlock, occlusionStrength),
                                                               TY_MEMBER(MaterialBlock, alphaCutoff),
                                                               TY_MEMBER(MaterialBlock, flags),
                                                               TY_MEMBER(MaterialBlock, baseColorUv),
                                                               TY_MEMBER(MaterialBlock, metallicRoughnessUv),
                                                               TY_MEMBER(MaterialBlock, normalUv),
                                                               TY_MEMBER(MaterialBlock, occlusionUv),
                                                               TY_MEMBER(MaterialBlock, emissiveUv),
                                                               {"sizeof", sizeof(shared::MaterialBlock)}}));
  EXPECT_EQ(reflect("geometry.vert", "InstanceBlock"), (Offsets{TY_MEMBER(InstanceBlock, worldFromObject),
                                                                TY_MEMBER(InstanceBlock, normalX),
                                                                TY_MEMBER(InstanceBlock, normalY),
                                                                TY_MEMBER(InstanceBlock, normalZ),
                                                                TY_MEMBER(InstanceBlock, mirrored),
                                                                {"sizeof", sizeof(shared::InstanceBlock)}}));
}

}  // namespace
}  // namespace tyndall
