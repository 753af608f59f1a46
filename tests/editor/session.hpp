// A session at the window, as a user has it: what the tests of whole sessions share.
#pragma once

#include "display.hpp"
#include "screen.hpp"

namespace tyndall::editor_test {

class SessionTest : public EditorTest {
 protected:
  using Json = nlohmann::json;

  /// Opens `level` with small maps in a window of `size` and waits until its picture is there.
  void start(const std::string& level, const std::string& size, const std::vector<std::string>& more = {});
  /// A level of a few triangles, in the test's folder, without a medium.
  void startTiny(const std::string& size, const std::vector<std::string>& more = {});
  std::filesystem::path tiny() const { return folder_ / "tiny.glb"; }
  void quit();

  std::string setting(const char* id) const { return state()["settings"][id]; }
  std::string fact(const char* name) const { return state()["facts"].value(name, ""); }
  std::vector<double> numbers(const char* name) const;
  bool becomes(const char* id, const std::string& value);
  bool factBecomes(const char* name, const std::string& value);
  bool appears(const std::string& widget);
  bool stepIs(int present);

  /// Waits until the window shows what the settings say and the mouse is out of the way, then looks.
  image::ByteImage look();
  /// The same, of the viewport alone.
  image::ByteImage lookAtPicture();

  /// Types a path into the file window that Ctrl and `key` open.
  void choose(const char* key, const std::filesystem::path& file);
  /// Opens the capture window and types the test's folder into it.
  void openCapture();
  /// Captures what is on screen and gives the command.
  std::string capture();
  /// Runs a captured command with another file for what it wrote; its exit status.
  int rerun(std::string command, const std::filesystem::path& captured, const std::filesystem::path& again);
  std::string pixelsOf(const std::filesystem::path& png) const;
};

}  // namespace tyndall::editor_test
