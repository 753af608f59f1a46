// Runs the program `tyndall` and keeps what it said.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace tyndall::cli {

struct Outcome {
  int status = -1;  ///< exit status; 1000 + signal when a signal ended it
  std::string out, err;
  std::vector<std::string> errorLines() const;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs bin/tyndall with `arguments` in `folder`.
Outcome run(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
            const Environment& environment = {});

std::string readText(const std::filesystem::path& path);
void writeText(const std::filesystem::path& path, const std::string& text);

/// A test with a folder of its own, removed afterwards.
class CliTest : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;
  Outcome tyndall(const std::vector<std::string>& arguments, const Environment& environment = {}) const {
    return run(folder_, arguments, environment);
  }
  /// Ids of all techniques that `describe --json` names.
  std::vector<std::string> techniques() const;
  /// Names of everything in the folder, sorted, hidden files too.
  std::vector<std::string> files() const;
  /// Runs and expects `status`, an empty stdout, one line on stderr that contains each of `words`, and no new file.
  void expectRefused(const std::vector<std::string>& arguments, int status, const std::vector<std::string>& words,
                     const Environment& environment = {}) const;

  std::filesystem::path folder_;
};

}  // namespace tyndall::cli
