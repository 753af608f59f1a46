// Bytes that a level refers to: data URIs and files beside it. Nothing outside the level's folder is ever opened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.hpp"
#include "import_log.hpp"

namespace tyndall::scene {

class Resources {
 public:
  /// `used`: bytes of the level file itself, which count towards kMaxFileBytes.
  Resources(const std::filesystem::path& levelFile, std::uint64_t used);

  /// The bytes behind a glTF URI. `what` names it in refusals. Refused: schemes other than data:, absolute paths, "..",
  /// links that lead outside the folder, missing files, more than kMaxFileBytes in all.
  std::vector<std::byte> load(const std::string& uri, const std::string& what);
  /// Of the bytes of every file that was read, in turn.
  std::uint64_t contentHash() const { return content_.value(); }

 private:
  std::vector<std::byte> loadFile(const std::string& uri, const std::string& what);
  std::filesystem::path folder_;
  std::uint64_t used_ = 0;
  Hash content_;
};

/// Percent-decoding (RFC 3986). Refuses nothing: a stray '%' stays as it is.
std::string percentDecoded(std::string_view text);
/// Base64 (RFC 4648) with or without padding; nothing when a character or the length is wrong.
bool base64Decoded(std::string_view text, std::vector<std::byte>& out);

}  // namespace tyndall::scene
