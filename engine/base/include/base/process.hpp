// What a program does once at its start, and what a signal that ends it leaves behind: nothing.
#pragma once

#include <atomic>
#include <filesystem>

namespace tyndall {

/// For main(): the three standard streams stand for something, so that no file of ours becomes one of them; a file that
/// may grow no further (SIGXFSZ) and a reader that has gone (SIGPIPE) are errors of the write; SIGINT, SIGTERM, SIGHUP
/// and SIGQUIT, where they end the program, first remove its temporary files.
void prepareProcess();

/// `tell` is called when one of those signals is about to end the program. It may only do what a signal handler may. At
/// most 4 are kept.
void beforeSignalEnds(void (*tell)());

/// While one of these lives, the signals above wait: for a few system calls that belong together.
class SignalsWait {
 public:
  SignalsWait();
  ~SignalsWait();
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
};

/// The name of a file in `folder` that is gone at the end of the object, or when one of those signals ends the program.
/// Names are short, whatever the file becomes in the end: a name of 255 bytes has no room for an ending. The object
/// makes no file; whoever does takes O_EXCL.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& folder);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// It has another name by now: nothing is removed, and path() is empty.
  void forget();

 private:
  std::filesystem::path path_;
  int slot_ = -1;
};

}  // namespace tyndall
