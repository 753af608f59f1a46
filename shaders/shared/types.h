// Lets one header declare a struct for C++ and GLSL. Blocks that hold such structs use `scalar` layout, whose offsets
// equal those of C++ with GLM's unaligned types; tests/render/shared_layout_test.cpp holds the two together.
#ifndef TYNDALL_SHARED_TYPES_H
#define TYNDALL_SHARED_TYPES_H

#ifdef __cplusplus
#include <cstdint>

#include <glm/glm.hpp>

#define TY_SHARED_BEGIN namespace tyndall::shared {
#define TY_SHARED_END }  // namespace tyndall::shared

namespace tyndall::shared {
using uint = std::uint32_t;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using uvec2 = glm::uvec2;
using mat4 = glm::mat4;
static_assert(sizeof(vec3) == 12 && alignof(mat4) == 4, "scalar layout needs GLM without forced alignment");
}  // namespace tyndall::shared
#else
#define TY_SHARED_BEGIN
#define TY_SHARED_END
#endif

#endif
