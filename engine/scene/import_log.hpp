// How the importer's parts refuse a file and collect warnings.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::scene {

/// Thrown by the importer's parts, caught by loadGltf only, which puts the path in front.
struct Refusal {
  std::string reason;
};
[[noreturn]] inline void refuse(std::string reason) { throw Refusal{std::move(reason)}; }

/// Thrown where a file reaches for what lies outside its folder: no broken part, and nothing of it is shown.
struct Escape {
  std::string reason;
};
[[noreturn]] inline void refuseEscape(std::string reason) { throw Escape{std::move(reason)}; }

/// Text of the file for use in a message: control characters escaped, cut after 80 bytes, in quotation marks.
std::string inQuotes(std::string_view text);
/// The same without the marks and with a longer limit, for messages of libraries.
std::string oneLine(std::string_view text);

inline std::string element(std::string_view array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

/// What becomes of things that are counted as broken (Warnings::count).
inline constexpr const char* kEachLeftOut = "each is left out";
inline constexpr const char* kImageKind = "textures without a usable image";
inline constexpr const char* kImageConsequence = "each is left out, and its material keeps its plain colour";

/// Each different warning once; what exceeds kMost is counted only.
class Warnings {
 public:
  void add(std::string line);
  /// One more of a kind, of which take() makes one line with their number and the first one:
  /// "textures without a usable image: 3, the first images[0] \"a.png\": cannot be opened; they are left out".
  void count(const std::string& kind, const std::string& one, const std::string& consequence);
  /// What was counted first of all, or nothing.
  const std::string& firstCounted() const { return firstCounted_; }
  std::vector<std::string> take();

 private:
  static constexpr std::size_t kMost = 50;
  struct Counted {
    std::string kind, first, consequence;
    std::size_t number = 0;
  };
  std::vector<Counted> counted_;  ///< in the order of the first of each kind
  std::string firstCounted_;
  std::set<std::string> seen_;
  std::vector<std::string> lines_;
  std::size_t dropped_ = 0;
};

}  // namespace tyndall::scene
