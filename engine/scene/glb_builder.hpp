// The binary side of a .glb under construction: buffer views and accessors over one growing buffer.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

namespace tyndall::scene {

/// glTF 2.0 section 3.6.2: GL enumerants.
enum class ViewTarget { kUnspecified = 0, kVertices = 34962, kIndices = 34963 };

class GlbBuilder {
 public:
  /// Each returns the new element's index. Everything starts at a multiple of four bytes.
  int view(std::span<const std::byte> bytes, ViewTarget target);
  int scalars(std::span<const float> values, ViewTarget target, bool withBounds);
  int indices(std::span<const std::uint32_t> values, std::size_t vertexCount);
  template <int N>
  int vectors(std::span<const glm::vec<N, float>> values, ViewTarget target, bool withBounds) {
    static_assert(sizeof(glm::vec<N, float>) == N * sizeof(float));
    return floats({reinterpret_cast<const float*>(values.data()), values.size() * N}, N, target, withBounds);
  }

  /// The whole file: header, JSON chunk padded with spaces, binary chunk padded with zeros.
  /// Adds accessors, bufferViews and buffers to `document`. Empty if it would exceed the format's 4 GiB.
  std::vector<std::byte> finish(nlohmann::ordered_json document) const;

 private:
  int floats(std::span<const float> values, int width, ViewTarget target, bool withBounds);
  std::vector<std::byte> bytes_;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

}  // namespace tyndall::scene
