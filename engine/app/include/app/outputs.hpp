// The files that one call writes: all of them or none.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace tyndall::app {

class Outputs {
 public:
  using Write = std::function<Result<void>(const std::filesystem::path&)>;

  /// Registers an output of `option` ("--out"). Checked at once, before any work: the path ends in `extension` (any
  /// case), its folder exists and can be written to, it is no folder or special file itself, and no other output has
  /// it.
  Result<void> add(const std::string& option, const std::filesystem::path& path, const std::string& extension);
  /// A file that the call reads, which no output may replace.
  void protect(const std::filesystem::path& path) { inputs_.push_back(path); }

  /// Writes the output of `option` beside its place under a temporary name. Nothing happens if it was not asked for.
  Result<void> write(const std::string& option, const Write& write);
  /// Puts every written file in place. If one cannot be, those already placed are removed again.
  Result<void> commit();
  /// Removes what was written and not committed.
  ~Outputs();

  std::vector<std::filesystem::path> paths() const;

 private:
  struct Output {
    std::string option;
    std::filesystem::path path, temporary;
    bool written = false;
  };
  std::vector<Output> outputs_;
  std::vector<std::filesystem::path> inputs_;
};

}  // namespace tyndall::app
