// FNV-1a, 64 bit (Fowler, Noll, Vo 1991): names things and notices changes; no defence against anybody.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace tyndall {

class Hash {
 public:
  Hash& bytes(std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes) value_ = (value_ ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ull;
    return *this;
  }
  Hash& text(std::string_view text) { return bytes(std::as_bytes(std::span(text.data(), text.size()))); }
  /// A value as it lies in memory: of types without padding.
  template <class T>
  requires std::is_trivially_copyable_v<T> Hash& add(const T& value) {
    return bytes(std::as_bytes(std::span(&value, 1)));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ull;
};

}  // namespace tyndall
