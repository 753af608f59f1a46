// The program `tyndall-editor`. Exit status: 0 done; 1 it failed; 2 the call was wrong. A failure is one line on
// stderr.
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "base/process.hpp"
#include "editor.hpp"
#include "options.hpp"

namespace tyndall::editor {
namespace {

int fail(const Error& error) {
  std::string line = error.message;
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  std::fprintf(stderr, "tyndall-editor: %s\n", line.c_str());
  return error.kind == ErrorKind::kBadCall ? 2 : 1;
}

int run(int argc, char** argv) {
  auto options = readOptions(argc, argv);
  if (!options) return fail(options.error());
  if (options->help) return std::fputs(helpText(), stdout) < 0 ? 1 : 0;
  auto editor = Editor::open(*options);
  if (!editor) return fail(editor.error());
  auto done = (*editor)->run();
  return done ? 0 : fail(done.error());
}

}  // namespace
}  // namespace tyndall::editor

int main(int argc, char** argv) try {
  tyndall::prepareProcess();
  return tyndall::editor::run(argc, argv);
} catch (const std::bad_alloc&) {
  std::fputs("tyndall-editor: out of memory; a smaller --size or level is needed\n", stderr);
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "tyndall-editor: unexpected: %s\n", error.what());
  return 1;
}
