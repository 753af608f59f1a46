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

/// Text of the file for use in a message: control characters escaped, cut after 80 bytes, in quotation marks.
std::string inQuotes(std::string_view text);
/// The same without the marks and with a longer limit, for messages of libraries.
std::string oneLine(std::string_view text);

inline std::string element(std::string_view array, std::size_t index) {
  return std::string(array) + "[" + std::to_string(index) + "]";
}

/// Each different warning once; what exceeds kMost is counted only.
class Warnings {
 public:
  void add(std::string line);
  std::vector<std::string> take();

 private:
  static constexpr std::size_t kMost = 50;
  std::set<std::string> seen_;
  std::vector<std::string> lines_;
  std::size_t dropped_ = 0;
};

}  // namespace tyndall::scene
