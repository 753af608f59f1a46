#include "app/outputs.hpp"

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstring>
#include <system_error>

#include <unistd.h>

namespace tyndall::app {
namespace fs = std::filesystem;

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool samePlace(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  if (fs::equivalent(a, b, ignored)) return true;
  // Of a path that does not exist, only an absolute one becomes canonical in full.
  return fs::weakly_canonical(fs::absolute(a, ignored), ignored) ==
         fs::weakly_canonical(fs::absolute(b, ignored), ignored);
}

/// Holds back the signals that end a program, so that none strikes between writing and placing files.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t set;
    sigemptyset(&set);
    for (int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&set, number);
    pthread_sigmask(SIG_BLOCK, &set, &before_);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

Result<void> Outputs::add(const std::string& option, const fs::path& path, const std::string& extension) {
  const std::string subject = option + " " + path.string() + ": ";
  if (path.empty()) return badCall(option + ": the file name is empty; a name ending in " + extension + " is needed");
  if (lower(path.extension().string()) != extension) return badCall(subject + "must end in " + extension);
  std::error_code failedCode;
  const fs::file_status status = fs::status(path, failedCode);
  if (fs::is_directory(status)) return failed(subject + "is a folder; a file name is needed");
  if (fs::exists(status) && !fs::is_regular_file(status))
    return failed(subject + "is not a regular file; name another");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failedCode))
    return failed(subject + "the folder " + folder.string() + " does not exist; make it first");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return failed(subject + "the folder " + folder.string() + " cannot be written to (" + std::strerror(errno) +
                  "); choose another");
  for (const Output& other : outputs_)
    if (samePlace(other.path, path))
      return badCall(subject + "is also the file of " + other.option + "; each needs its own");
  for (const fs::path& input : inputs_)
    if (samePlace(input, path)) return badCall(subject + "is an input of this call; name another file");
  outputs_.push_back({option, path, {}, false});
  return {};
}

Result<void> Outputs::write(const std::string& option, const Write& write) {
  const SignalsHeld held;
  for (Output& output : outputs_) {
    if (output.option != option) continue;
    // Beside its final place, so that placing it is a rename within one file system.
    output.temporary =
        output.path.parent_path() / (".tyndall-" + std::to_string(::getpid()) + "-" + output.path.filename().string());
    auto done = write(output.temporary);
    if (!done) {
      std::string message = done.error().message;
      // The user knows the name asked for, not the temporary one.
      if (const auto at = message.find(output.temporary.string()); at != std::string::npos)
        message.replace(at, output.temporary.string().size(), output.path.string());
      return Error{option + " " + message, done.error().kind};
    }
    output.written = true;
  }
  return {};
}

Result<void> Outputs::commit() {
  const SignalsHeld held;
  std::vector<fs::path> placed;
  for (Output& output : outputs_) {
    if (!output.written) continue;
    std::error_code failedCode;
    fs::rename(output.temporary, output.path, failedCode);
    if (failedCode) {
      std::error_code ignored;
      for (const fs::path& path : placed) fs::remove(path, ignored);
      return failed(output.option + " " + output.path.string() + ": cannot be put in place: " + failedCode.message());
    }
    output.written = false;
    placed.push_back(output.path);
  }
  return {};
}

Outputs::~Outputs() {
  std::error_code ignored;
  for (const Output& output : outputs_)
    if (output.written) fs::remove(output.temporary, ignored);
}

std::vector<fs::path> Outputs::paths() const {
  std::vector<fs::path> all;
  for (const Output& output : outputs_) all.push_back(output.path);
  return all;
}

}  // namespace tyndall::app
