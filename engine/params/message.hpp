// Pieces of one-line error messages.
#pragma once

#include <string>
#include <string_view>

namespace tyndall::params {

/// Named so that std::quoted is not found instead. 'text' in quotes, safe inside one line: control characters become
/// '?', a long text is cut.
inline std::string quote(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string out = "'";
  for (const char c : text.substr(0, kLongest)) out += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? '?' : c;
  return out + (text.size() > kLongest ? "...'" : "'");
}

}  // namespace tyndall::params
