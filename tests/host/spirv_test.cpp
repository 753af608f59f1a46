// Reading a shader's bindings.
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "spirv_interface.hpp"

namespace tyndall::host {
namespace {

using testing::HasSubstr;

std::vector<std::uint32_t> fog() {
  const auto bytes = readFile(TYNDALL_BIN_DIR "/sample_plugins/fog_depth/fog.comp.spv");
  EXPECT_TRUE(bytes);
  std::vector<std::uint32_t> code(bytes->size() / 4);
  std::memcpy(code.data(), bytes->data(), code.size() * 4);
  return code;
}

const std::vector<ShaderBinding> kFog = {{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
                                         {1, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
                                         {2, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER}};

TEST(Spirv, bindingsOfTheTemplate) {
  const auto bindings = shaderBindings(fog());
  ASSERT_TRUE(bindings) << bindings.error().message;
  ASSERT_EQ(bindings->size(), 3u);
  EXPECT_TRUE(checkShaderBindings(fog(), kFog));
}

TEST(Spirv, aTableThatDisagreesIsRefused) {
  auto fewer = kFog;
  fewer.pop_back();
  EXPECT_THAT(checkShaderBindings(fog(), fewer).error().message,
              HasSubstr("binding 2 as a uniform block, which the pass's table lacks"));
  auto other = kFog;
  other[0].type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  EXPECT_THAT(checkShaderBindings(fog(), other).error().message,
              HasSubstr("binding 0 as a sampled image, but the pass's table gives a storage image"));
  auto more = kFog;
  more.push_back({9, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER});
  EXPECT_TRUE(checkShaderBindings(fog(), more));
}

TEST(Spirv, damagedCodeIsRefusedNotACrash) {
  auto code = fog();
  EXPECT_FALSE(shaderBindings({}));
  EXPECT_FALSE(shaderBindings(std::span(code).first(3)));
  auto magic = code;
  magic[0] = 0;
  EXPECT_FALSE(shaderBindings(magic));
  auto endless = code;
  endless[5] = 0;  // an instruction of no words
  EXPECT_FALSE(shaderBindings(endless));
  std::uint32_t random = 1;
  for (int i = 0; i < 2000; ++i) {  // whatever comes of it, it ends and stays inside
    auto spoilt = code;
    random = random * 1664525u + 1013904223u;
    spoilt[5 + random % (code.size() - 5)] = random;
    (void)shaderBindings(std::span(spoilt).first(5 + (random >> 8) % (code.size() - 5)));
  }
}

}  // namespace
}  // namespace tyndall::host
