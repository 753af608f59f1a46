// Versions and sized structs.
#include <cstddef>

#include <gtest/gtest.h>

#include "host/abi.hpp"

extern "C" {
extern const std::size_t abiSizesInC[];
extern const std::size_t abiSizeCountInC;
}

namespace tyndall::host {
namespace {

std::uint32_t version(std::uint32_t major, std::uint32_t minor) { return major << 16 | minor; }

TEST(Version, sameMajorAndNoNewerMinor) {
  EXPECT_TRUE(checkAbiVersion(version(1, 0), version(1, 0)));
  EXPECT_TRUE(checkAbiVersion(version(1, 2), version(1, 3)));
  EXPECT_TRUE(checkAbiVersion(version(1, 3), version(1, 3)));
  EXPECT_FALSE(checkAbiVersion(version(1, 4), version(1, 3)));
  EXPECT_FALSE(checkAbiVersion(version(2, 0), version(1, 3)));
  EXPECT_FALSE(checkAbiVersion(version(0, 3), version(1, 3)));
  EXPECT_FALSE(checkAbiVersion(0, version(1, 3)));
  EXPECT_FALSE(checkAbiVersion(0xffffffffu, version(1, 3)));
}

TEST(Structs, haveTheSameSizeInCAndCpp) {
  const std::size_t sizes[] = {sizeof(TyParameter),   sizeof(TyDevice),       sizeof(TyStructure), sizeof(TyImage),
                               sizeof(TyBuffer),      sizeof(TyUniformBlock), sizeof(TyBinding),   sizeof(TyTarget),
                               sizeof(TyPass),        sizeof(TyDebugView),    sizeof(TyCounters),  sizeof(TyTunable),
                               sizeof(TyLayout),      sizeof(TyView),         sizeof(TyLight),     sizeof(TyFrame),
                               sizeof(TyUniformData), sizeof(TyHost),         sizeof(TyTechnique), sizeof(TyPlugin)};
  ASSERT_EQ(std::size(sizes), abiSizeCountInC);
  for (std::size_t i = 0; i < std::size(sizes); ++i) EXPECT_EQ(sizes[i], abiSizesInC[i]) << i;
}

/// An element as an older (shorter) or newer (longer) side would make it.
struct Older {
  std::uint32_t struct_size, binding, source;
};
struct Newer {
  TyBinding known;
  std::uint32_t future[3];
};

TEST(Structs, olderOnesAreFilledWithZeros) {
  const Older old{sizeof(Older), 7, TY_SOURCE_OUTPUT};
  const auto read = readStruct<TyBinding>(&old);
  EXPECT_EQ(read.binding, 7u);
  EXPECT_EQ(read.source, static_cast<std::uint32_t>(TY_SOURCE_OUTPUT));
  EXPECT_EQ(read.index, 0u);
  EXPECT_EQ(read.layer_count, 0u);
}

TEST(Arrays, areSteppedByTheirOwnSize) {
  Newer newer[3]{};
  Older older[3]{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    newer[i].known.struct_size = sizeof(Newer);
    newer[i].known.binding = older[i].binding = 10 + i;
    newer[i].future[0] = 0xdddddddd;
    older[i].struct_size = sizeof(Older);
  }
  const TyBinding* const arrays[] = {&newer[0].known, reinterpret_cast<const TyBinding*>(&older[0])};
  for (const TyBinding* first : arrays) {
    const auto read = readArray(first, 3, "bindings");
    ASSERT_TRUE(read) << read.error().message;
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(read.value()[i].binding, 10 + i);
  }
}

TEST(Arrays, refuseGarbage) {
  TyBinding bindings[2]{};
  EXPECT_FALSE(readArray(bindings, 2, "bindings")) << "sizes of 0 would step nowhere";
  bindings[0].struct_size = sizeof(TyBinding);
  EXPECT_FALSE(readArray(bindings, 2, "bindings")) << "the second was not filled";
  bindings[0].struct_size = 0xffffffff;
  EXPECT_FALSE(readArray(bindings, 1, "bindings"));
  EXPECT_FALSE(readArray<TyBinding>(nullptr, 1, "bindings"));
  EXPECT_FALSE(readArray(bindings, kMostElements + 1, "bindings"));
  EXPECT_TRUE(readArray<TyBinding>(nullptr, 0, "bindings"));
}

TEST(Texts, areOneLineAndBounded) {
  EXPECT_EQ(*readText("a\nb\tc", "x"), "a b c");
  EXPECT_FALSE(readText(nullptr, "x"));
  EXPECT_TRUE(readText("", "x"));
  EXPECT_FALSE(readName("", "x"));
  EXPECT_FALSE(readText(std::string(5000, 'a').c_str(), "x"));
  EXPECT_FALSE(readName(std::string(200, 'a').c_str(), "x"));
}

}  // namespace
}  // namespace tyndall::host
