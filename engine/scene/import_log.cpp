#include "import_log.hpp"

#include <utility>

namespace tyndall::scene {
namespace {

std::string escaped(std::string_view text, std::size_t limit) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == limit) return out + "...";
    const auto c = static_cast<unsigned char>(text[i]);
    if (c >= 0x20 && c != 0x7f) {
      out += text[i];
    } else {
      out += "\\x";
      out += kHex[c >> 4];
      out += kHex[c & 15];
    }
  }
  return out;
}

}  // namespace

std::string inQuotes(std::string_view text) { return "\"" + escaped(text, 80) + "\""; }
std::string oneLine(std::string_view text) { return escaped(text, 200); }

void Warnings::add(std::string line) {
  if (lines_.size() == kMost) {
    ++dropped_;
    return;
  }
  if (seen_.insert(line).second) lines_.push_back(std::move(line));
}

void Warnings::count(const std::string& kind, const std::string& one, const std::string& consequence) {
  if (firstCounted_.empty()) firstCounted_ = one;
  for (Counted& counted : counted_)
    if (counted.kind == kind && counted.consequence == consequence) return void(++counted.number);
  counted_.push_back({kind, one, consequence, 1});
}

std::vector<std::string> Warnings::take() {
  for (const Counted& counted : counted_)
    lines_.push_back(counted.kind + ": " + std::to_string(counted.number) +
                     (counted.number == 1 ? ", " : ", the first ") + counted.first + "; " + counted.consequence);
  if (dropped_) lines_.push_back("and " + std::to_string(dropped_) + " more warnings");
  return std::move(lines_);
}

}  // namespace tyndall::scene
