#include "rooms.hpp"

#include <map>

namespace tyndall::arrows {
namespace {

/// Direct arrows. Everything else follows from them.
const std::map<std::string, std::vector<std::string>>& arrows() {
  static const std::map<std::string, std::vector<std::string>> table = {
      {"base", {}},
      {"image", {"base"}},
      {"params", {"base"}},
      {"gpu", {"base"}},
      {"scene", {"base"}},
      {"render", {"gpu", "scene", "base", "shared"}},
      {"host", {"render", "params", "abi", "shared"}},
      {"truth", {"scene", "base"}},
      {"app", {"host", "render", "params", "gpu", "scene", "truth", "image", "base"}},
      {"bench", {"app", "host", "render", "params", "gpu", "scene", "truth", "image", "base"}},
      {"editor", {"app", "shared"}},
      {"levels", {"scene", "base", "image"}},
      {"abi", {}},
      {"shared", {}},
      {"lib", {"shared"}},
      {"shaders", {"lib", "shared"}},
  };
  return table;
}

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

std::string folder(const std::string& path, std::size_t depth) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < depth; ++i) {
    begin = path.find('/', begin);
    if (begin == std::string::npos) return "";
    ++begin;
  }
  const std::size_t end = path.find('/', begin);
  return end == std::string::npos ? "" : path.substr(begin, end - begin);
}

}  // namespace

const std::vector<std::string>& engineRooms() {
  static const std::vector<std::string> rooms = {"base",   "image", "params", "gpu", "scene",
                                                 "render", "host",  "truth",  "app", "bench"};
  return rooms;
}

std::string roomOf(const std::string& path) {
  if (path.ends_with("_test.cpp")) return "tests";  // a technique's tests lie beside it
  if (startsWith(path, "engine/")) return folder(path, 1);
  if (startsWith(path, "plugins/abi/")) return "abi";
  if (startsWith(path, "plugins/")) return "plugin:" + folder(path, 1);
  if (startsWith(path, "shaders/shared/")) return "shared";
  if (startsWith(path, "shaders/lib/")) return "lib";
  if (startsWith(path, "shaders/")) return "shaders";
  if (startsWith(path, "editor/")) return "editor";
  if (startsWith(path, "samples/levels/")) return "levels";
  if (startsWith(path, "samples/")) return "plugin:sample/" + folder(path, 1);
  if (startsWith(path, "tests/")) return "tests";
  return "";
}

std::set<std::string> visibleFrom(const std::string& room) {
  std::set<std::string> seen;
  std::vector<std::string> open = {room};
  if (startsWith(room, "plugin:")) open = {room, "abi", "shared", "lib"};
  while (!open.empty()) {
    const std::string next = open.back();
    open.pop_back();
    if (!seen.insert(next).second) continue;
    if (const auto found = arrows().find(next); found != arrows().end())
      open.insert(open.end(), found->second.begin(), found->second.end());
  }
  return seen;
}

}  // namespace tyndall::arrows
