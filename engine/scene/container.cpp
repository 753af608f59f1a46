#include "container.hpp"

#include <cstdint>
#include <cstring>

#include "base/json_shape.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;

/// GLB is little-endian, as is every machine that Tyndall runs on.
std::uint32_t word(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

Container openGlb(std::span<const std::byte> file, Warnings& warnings) {
  if (file.size() < 12) refuse("a .glb header has 12 bytes; the file ends after " + std::to_string(file.size()));
  if (const auto version = word(file, 4); version != 2)
    refuse("the .glb container has version " + std::to_string(version) + "; only 2 is known");
  const std::uint32_t length = word(file, 8);
  if (length > file.size())
    refuse("truncated: the .glb header announces " + std::to_string(length) + " bytes, the file has " +
           std::to_string(file.size()));
  if (length < 20)
    refuse("the .glb header announces " + std::to_string(length) + " bytes; that leaves no room for a JSON chunk");
  if (length < file.size())
    warnings.add(std::to_string(file.size() - length) + " bytes after the .glb's announced end were ignored");
  Container out;
  for (std::size_t at = 12, chunk = 0; at < length; ++chunk) {
    if (length - at < 8) refuse("truncated in the header of .glb chunk " + std::to_string(chunk));
    const std::uint32_t size = word(file, at), type = word(file, at + 4);
    at += 8;
    if (size > length - at)
      refuse(".glb chunk " + std::to_string(chunk) + " announces " + std::to_string(size) + " bytes; " +
             std::to_string(length - at) + " are left");
    const auto content = file.subspan(at, size);
    if (chunk == 0) {
      if (type != kJsonChunk) refuse("the first .glb chunk is not JSON");
      out.json = {reinterpret_cast<const char*>(content.data()), content.size()};
    } else if (type == kJsonChunk) {
      refuse("the .glb has more than one JSON chunk");
    } else if (type == kBinChunk && chunk == 1) {
      out.binary = content;
    } else if (type == kBinChunk) {
      warnings.add(".glb chunk " + std::to_string(chunk) + " is a misplaced binary chunk and was ignored");
    }
    at += size;
  }
  return out;
}

}  // namespace

Container openContainer(std::span<const std::byte> file, Warnings& warnings) {
  if (file.empty()) refuse("is empty");
  if (file.size() >= 4 && word(file, 0) == kMagic) return openGlb(file, warnings);
  const char first = static_cast<char>(file[0]);
  const bool mayBeJson =
      first == '{' || first == ' ' || first == '\t' || first == '\r' || first == '\n' || first == '\xEF';
  if (!mayBeJson) refuse("is neither glTF (JSON text) nor GLB (starts with \"glTF\")");
  return {{reinterpret_cast<const char*>(file.data()), file.size()}, {}};
}

void checkJsonShape(std::string_view json) {
  const std::string problem = jsonShapeProblem(json, kMaxJsonValues);
  if (!problem.empty()) refuse("its JSON " + problem);
}

}  // namespace tyndall::scene
