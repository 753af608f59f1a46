// Reading what comes across the plugin ABI: sized structs, arrays of them, strings, versions. Nothing here trusts a
// number that a plugin gave before it is checked.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "base/result.hpp"
#include "tyndall/plugin.h"

namespace tyndall::host {

/// Refuses a plugin of another major version, or of a newer minor one than `host` (both as TY_ABI_VERSION).
Result<void> checkAbiVersion(std::uint32_t plugin, std::uint32_t host = TY_ABI_VERSION);

/// Copies min(struct_size, sizeof(T)) bytes of a struct that starts with its size into zeroed memory.
/// `sizeOffset`: where struct_size is (TyPlugin has abi_version first).
template <class T>
T readStruct(const void* from, std::size_t sizeOffset = 0) {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_default_constructible_v<T>);
  T copy;
  std::memset(&copy, 0, sizeof copy);
  std::uint32_t size = 0;
  std::memcpy(&size, static_cast<const char*>(from) + sizeOffset, sizeof size);
  std::memcpy(&copy, from, std::min<std::size_t>(size, sizeof copy));
  return copy;
}

/// No array of a sane plugin is longer; a count beyond it is garbage.
inline constexpr std::uint32_t kMostElements = 4096;

/// An array of sized structs, stepped by the first element's struct_size. `what` names it in errors ("images").
template <class T>
Result<std::vector<T>> readArray(const T* first, std::uint32_t count, const std::string& what) {
  std::vector<T> elements;
  if (count == 0) return elements;
  if (first == nullptr)
    return failed(what + ": the array is null but its count is " + std::to_string(count) +
                  "; give the array or count 0");
  if (count > kMostElements)
    return failed(what + ": there are " + std::to_string(count) + "; at most " + std::to_string(kMostElements) +
                  " are taken");
  const char* bytes = reinterpret_cast<const char*>(first);
  std::uint32_t stride = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes + std::size_t{i} * stride, sizeof size);
    if (i == 0) stride = size;
    // 64 KiB: larger than any struct can grow to; a size that differs from the first means that the array was not
    // filled.
    if (size < sizeof size || size > 65536 || size != stride)
      return failed(what + "[" + std::to_string(i) + "]: struct_size is " + std::to_string(size) +
                    "; every element needs the sizeof of its type");
    elements.push_back(readStruct<T>(bytes + std::size_t{i} * stride));
  }
  return elements;
}

/// A string of a plugin as one printable line (control characters become spaces) of at most 4096 bytes.
Result<std::string> readText(const char* text, const std::string& what);
/// The same for a name: not empty, at most 128 bytes.
Result<std::string> readName(const char* text, const std::string& what);

}  // namespace tyndall::host
