#include "resources.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/file.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace fs = std::filesystem;
namespace {

constexpr std::uint8_t kBad = 0xff;

std::array<std::uint8_t, 256> base64Table() {
  std::array<std::uint8_t, 256> table;
  table.fill(kBad);
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    table[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  return table;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int lower = std::tolower(static_cast<unsigned char>(c));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// RFC 3986 section 3.1: a letter, then letters, digits, "+", "-", ".", up to a colon.
bool hasScheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0 || !std::isalpha(static_cast<unsigned char>(uri[0]))) return false;
  return std::all_of(uri.begin(), uri.begin() + static_cast<std::ptrdiff_t>(colon),
                     [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; });
}

bool isDataUri(std::string_view uri) {
  if (uri.size() < 5) return false;
  std::string head(uri.substr(0, 5));
  std::transform(head.begin(), head.end(), head.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return head == "data:";
}

std::vector<std::byte> loadDataUri(std::string_view uri, const std::string& what) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) refuse(what + ": its data URI has no comma");
  const std::string_view header = uri.substr(0, comma), body = uri.substr(comma + 1);
  std::vector<std::byte> out;
  if (header.ends_with(";base64")) {
    if (!base64Decoded(body, out)) refuse(what + ": its data URI is not valid base64");
  } else {
    const std::string text = percentDecoded(body);
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    out.assign(begin, begin + text.size());
  }
  return out;
}

}  // namespace

std::string percentDecoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hexDigit(text[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(text[i + 2]) : -1;
    if (low >= 0) {
      out += static_cast<char>(high * 16 + low);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

bool base64Decoded(std::string_view text, std::vector<std::byte>& out) {
  static const std::array<std::uint8_t, 256> kTable = base64Table();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return false;
  out.clear();
  out.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::uint8_t value = kTable[static_cast<unsigned char>(c)];
    if (value == kBad) return false;
    bits = bits << 6 | value;
    count += 6;
    if (count >= 8) {
      count -= 8;
      out.push_back(static_cast<std::byte>(bits >> count & 0xff));
    }
  }
  return true;
}

Resources::Resources(const fs::path& levelFile, std::uint64_t used) : used_(used) {
  const fs::path parent = levelFile.parent_path();
  std::error_code ignored;  // a folder that cannot be resolved makes every file in it unreadable, which loadFile says
  folder_ = fs::weakly_canonical(parent.empty() ? fs::path(".") : parent, ignored);
}

std::vector<std::byte> Resources::load(const std::string& uri, const std::string& what) {
  if (uri.empty()) refuse(what + ": its URI is empty");
  return isDataUri(uri) ? loadDataUri(uri, what) : loadFile(uri, what);
}

std::vector<std::byte> Resources::loadFile(const std::string& uri, const std::string& what) {
  const std::string subject = what + " " + inQuotes(uri);
  if (hasScheme(uri)) refuseEscape(subject + ": network and other addresses are not read; only files beside the level");
  std::string relative = percentDecoded(uri);
  std::replace(relative.begin(), relative.end(), '\\', '/');  // of exporters on Windows
  if (relative.find('\0') != std::string::npos) refuse(subject + ": not a file name");
  const fs::path asked(relative);
  if (asked.is_absolute()) refuseEscape(subject + ": absolute paths are not read; only files beside the level");
  const auto inside = [&](const fs::path& path) {
    return std::mismatch(folder_.begin(), folder_.end(), path.begin(), path.end()).first == folder_.end();
  };
  // By its letters first: ".." may lead out and in again, and nothing outside is looked at on the way.
  const fs::path normal = (folder_ / asked).lexically_normal();
  if (!inside(normal)) refuseEscape(subject + ": leads outside the level's folder");
  std::error_code missing;
  const fs::path resolved = fs::canonical(normal, missing);
  if (missing) refuse(subject + ": cannot be opened: " + missing.message());
  if (!inside(resolved)) refuseEscape(subject + ": is a link that leads outside the level's folder");
  auto bytes = readFile(resolved, kMaxFileBytes - used_);
  if (!bytes) {
    // The error starts with the resolved path; the level's author knows the URI.
    const std::string& message = bytes.error().message;
    const std::string prefix = resolved.string() + ": ";
    refuse(subject + ": " + oneLine(message.starts_with(prefix) ? message.substr(prefix.size()) : message));
  }
  used_ += bytes->size();
  content_.add(bytes->size()).bytes(*bytes);
  return bytes.take();
}

}  // namespace tyndall::scene
