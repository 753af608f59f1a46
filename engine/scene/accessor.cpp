#include "accessor.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tyndall::scene {
namespace {

// GL enumerants of glTF 2.0 section 3.6.2.2.
enum : int { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };

/// Accessors without a buffer view hold zeros and so cost no file bytes; this bounds what they cost in memory.
constexpr std::size_t kMaxZeroElements = 1u << 20;

std::size_t componentSize(int type) {
  return type == kByte || type == kUnsignedByte ? 1 : type == kShort || type == kUnsignedShort ? 2 : 4;
}

template <class T>
T load(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);  // files need not be aligned
  return value;
}

float component(const unsigned char* at, int type, bool normalize) {
  switch (type) {
    case kByte:
      return normalize ? std::max(static_cast<float>(load<std::int8_t>(at)) / 127.0f, -1.0f) : load<std::int8_t>(at);
    case kUnsignedByte: return normalize ? static_cast<float>(*at) / 255.0f : *at;
    case kShort:
      return normalize ? std::max(static_cast<float>(load<std::int16_t>(at)) / 32767.0f, -1.0f)
                       : load<std::int16_t>(at);
    case kUnsignedShort:
      return normalize ? static_cast<float>(load<std::uint16_t>(at)) / 65535.0f : load<std::uint16_t>(at);
    case kUnsignedInt: return static_cast<float>(load<std::uint32_t>(at));
    default: return load<float>(at);
  }
}

}  // namespace

AccessorReader::AccessorReader(const document::Document& document, int accessor, std::string what)
    : document_(document), accessor_(document.accessors[accessor]), what_(std::move(what)) {
  if (accessor_.width == 0) refuse(what_ + " is a matrix");
  size_ = componentSize(accessor_.componentType) * accessor_.width;
  if (accessor_.count == 0) refuse(what_ + " has no elements");
  if (accessor_.view != kNone) {
    base_ = span(accessor_.view, accessor_.byteOffset, accessor_.count, size_, stride_);
  } else if (accessor_.count > kMaxZeroElements) {
    refuse(what_ + " has " + std::to_string(accessor_.count) + " elements but no buffer view");
  }
  if (accessor_.sparse.count) openSparse();
}

const unsigned char* AccessorReader::span(int viewIndex, std::size_t offset, std::size_t count, std::size_t size,
                                          std::size_t& stride) const {
  const document::BufferView& view = document_.views[viewIndex];
  const auto& buffer = document_.buffers[view.buffer];
  stride = view.byteStride ? view.byteStride : size;
  if (stride < size)
    refuse(what_ + ": a stride of " + std::to_string(stride) + " bytes is below its element's " + std::to_string(size));
  const std::uint64_t end = offset + (count - 1) * stride + size;
  if (end > view.byteLength)
    refuse(what_ + " needs " + std::to_string(end) + " bytes; its buffer view has " + std::to_string(view.byteLength));
  if (view.byteOffset + view.byteLength > buffer.size())
    refuse(what_ + ": its buffer view ends at byte " + std::to_string(view.byteOffset + view.byteLength) +
           "; the buffer has " + std::to_string(buffer.size()));
  return buffer.data() + view.byteOffset + offset;
}

void AccessorReader::openSparse() {
  const document::Sparse& sparse = accessor_.sparse;
  if (sparse.count > accessor_.count) refuse(what_ + " has more sparse elements than elements");
  const std::size_t indexSize = componentSize(sparse.indexType);
  std::size_t indexStride = 0, valueStride = 0;
  const unsigned char* indices = span(sparse.indexView, sparse.indexOffset, sparse.count, indexSize, indexStride);
  sparseValues_ = span(sparse.valueView, sparse.valueOffset, sparse.count, size_, valueStride);
  if (indexStride != indexSize || valueStride != size_) refuse(what_ + ": its sparse buffer views have a stride");
  sparseAt_.resize(sparse.count);
  for (std::size_t i = 0; i < sparse.count; ++i) {
    sparseAt_[i] = unsignedAt(indices + i * indexSize, sparse.indexType);
    if (sparseAt_[i] >= accessor_.count || (i > 0 && sparseAt_[i] <= sparseAt_[i - 1]))
      refuse(what_ + ": its sparse indices are not strictly increasing below its count");
  }
}

std::uint32_t AccessorReader::unsignedAt(const unsigned char* at, int componentType) {
  return componentType == kUnsignedByte    ? *at
         : componentType == kUnsignedShort ? load<std::uint16_t>(at)
                                           : load<std::uint32_t>(at);
}

const unsigned char* AccessorReader::elementAt(std::size_t i) const {
  static constexpr unsigned char kZeros[16] = {};
  if (!sparseAt_.empty()) {
    const auto found = std::lower_bound(sparseAt_.begin(), sparseAt_.end(), i);
    if (found != sparseAt_.end() && *found == i) return sparseValues_ + (found - sparseAt_.begin()) * size_;
  }
  return base_ ? base_ + i * stride_ : kZeros;
}

bool AccessorReader::finite(std::size_t i) const {
  if (accessor_.componentType != kFloat) return true;
  const unsigned char* at = elementAt(i);
  for (int c = 0; c < accessor_.width; ++c)
    if (!std::isfinite(load<float>(at + c * sizeof(float)))) return false;
  return true;
}

glm::vec4 AccessorReader::vector(std::size_t i, const glm::vec4& fallback, bool normalize) const {
  glm::vec4 out = fallback;
  const unsigned char* at = elementAt(i);
  for (int c = 0; c < accessor_.width; ++c) {
    out[c] = component(at + c * componentSize(accessor_.componentType), accessor_.componentType,
                       normalize || accessor_.normalized);
    if (!std::isfinite(out[c])) refuse(what_ + ": element " + std::to_string(i) + " is not finite");
  }
  return out;
}

}  // namespace tyndall::scene
