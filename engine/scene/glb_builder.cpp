#include "glb_builder.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

namespace tyndall::scene {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;  // glTF 2.0 section 3.6.2.2

template <class T>
void append(std::vector<std::byte>& out, const T& value) {
  const auto* begin = reinterpret_cast<const std::byte*>(&value);
  out.insert(out.end(), begin, begin + sizeof value);
}

}  // namespace

int GlbBuilder::view(std::span<const std::byte> bytes, ViewTarget target) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
  if (target != ViewTarget::kUnspecified) view["target"] = static_cast<int>(target);
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  views_.push_back(std::move(view));
  return static_cast<int>(views_.size()) - 1;
}

int GlbBuilder::floats(std::span<const float> values, int width, ViewTarget target, bool withBounds) {
  static constexpr const char* kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  Json accessor = {{"bufferView", view(std::as_bytes(values), target)},
                   {"componentType", kFloat},
                   {"count", values.size() / width},
                   {"type", kTypes[width]}};
  if (withBounds) {
    Json low = Json::array(), high = Json::array();
    for (int component = 0; component < width; ++component) {
      float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
      for (std::size_t i = component; i < values.size(); i += width) {
        lowest = std::min(lowest, values[i]);
        highest = std::max(highest, values[i]);
      }
      low.push_back(lowest);
      high.push_back(highest);
    }
    accessor["min"] = std::move(low);
    accessor["max"] = std::move(high);
  }
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuilder::scalars(std::span<const float> values, ViewTarget target, bool withBounds) {
  return floats(values, 1, target, withBounds);
}

int GlbBuilder::indices(std::span<const std::uint32_t> values, std::size_t vertexCount) {
  int bufferView = 0;
  // 65535 itself is forbidden: graphics interfaces read it as "restart the primitive".
  const bool small = vertexCount <= 65535;
  if (small) {
    std::vector<std::uint16_t> narrow(values.size());
    std::transform(values.begin(), values.end(), narrow.begin(),
                   [](std::uint32_t i) { return static_cast<std::uint16_t>(i); });
    bufferView = view(std::as_bytes(std::span(narrow)), ViewTarget::kIndices);
  } else {
    bufferView = view(std::as_bytes(values), ViewTarget::kIndices);
  }
  accessors_.push_back({{"bufferView", bufferView},
                        {"componentType", small ? kUnsignedShort : kUnsignedInt},
                        {"count", values.size()},
                        {"type", "SCALAR"}});
  return static_cast<int>(accessors_.size()) - 1;
}

std::vector<std::byte> GlbBuilder::finish(Json document) const {
  if (!accessors_.empty()) document["accessors"] = accessors_;
  if (!views_.empty()) document["bufferViews"] = views_;
  const std::size_t binarySize = (bytes_.size() + 3) / 4 * 4;
  if (!bytes_.empty()) document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  // Names may be any bytes; glTF is UTF-8.
  std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t total = 12 + 8 + text.size() + (bytes_.empty() ? 0 : 8 + binarySize);
  if (total > std::numeric_limits<std::uint32_t>::max()) return {};
  std::vector<std::byte> file;
  file.reserve(total);
  append(file, std::uint32_t{0x46546C67});  // "glTF"
  append(file, std::uint32_t{2});
  append(file, static_cast<std::uint32_t>(total));
  append(file, static_cast<std::uint32_t>(text.size()));
  append(file, std::uint32_t{0x4E4F534A});  // "JSON"
  const auto json = std::as_bytes(std::span(text.data(), text.size()));
  file.insert(file.end(), json.begin(), json.end());
  if (!bytes_.empty()) {
    append(file, static_cast<std::uint32_t>(binarySize));
    append(file, std::uint32_t{0x004E4942});  // "BIN\0"
    file.insert(file.end(), bytes_.begin(), bytes_.end());
    file.resize(total);
  }
  return file;
}

}  // namespace tyndall::scene
