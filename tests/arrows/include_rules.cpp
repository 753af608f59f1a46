#include "include_rules.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "rooms.hpp"

namespace tyndall::arrows {
namespace {

/// A library from outside: how its headers start, who may include it, and in how many files of the whole project.
struct Library {
  const char* name;
  std::vector<std::string> prefixes;
  std::vector<std::string> rooms;
  bool inHeaders = true;                    ///< headers that others include may include it
  std::size_t maxFiles = 0;                 ///< 0: any number
  std::vector<std::string> alsoFiles = {};  ///< single files of other rooms, each with its reason below
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> all = {
      {"Dear ImGui", {"imgui", "backends/imgui"}, {"editor"}},
      {"GLFW", {"GLFW/"}, {"editor"}},
      {"tinygltf", {"tiny_gltf"}, {"scene"}, false, 1},
      // gpu/sanitizer.cpp keeps a loaded driver's symbols for leak reports; it opens nothing, and only in sanitizer
      // builds.
      {"dlopen", {"dlfcn.h"}, {"host"}, true, 0, {"engine/gpu/sanitizer.cpp"}},
      {"Embree", {"embree3/", "embree4/"}, {"truth"}},
      {"OpenEXR", {"Imf", "OpenEXR/", "tinyexr"}, {"image"}, false},
      {"stb", {"stb_", "stb/"}, {"image", "scene"}, false},
      {"libpng and libjpeg", {"png.h", "jpeglib.h", "turbojpeg.h"}, {"scene", "image"}, false},
      {"CLI11", {"CLI/"}, {"app", "editor", "levels"}, false},
      {"spdlog", {"spdlog/"}, {"base"}, false},
      {"nlohmann_json", {"nlohmann/"}, {"app", "params", "scene", "gpu", "host", "editor", "levels", "bench"}, false},
      {"Vulkan", {"vulkan/", "volk.h"}, {"gpu", "render", "host", "app", "editor"}},
      {"glslang and SPIR-V tools", {"glslang/", "SPIRV/", "spirv-tools/", "spirv_cross", "spirv/"}, {"gpu", "host"}},
  };
  return all;
}

bool startsWith(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }
bool contains(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}
bool isHeader(const std::string& path) { return path.ends_with(".hpp") || path.ends_with(".h"); }

const Library* libraryOf(const std::string& target) {
  for (const Library& library : libraries())
    for (const std::string& prefix : library.prefixes)
      if (startsWith(target, prefix)) return &library;
  return nullptr;
}

/// True for the C++ and C standard libraries: no folder, and no extension or a C header's name.
bool isStandard(const std::string& target) {
  static const std::regex name(
      "[a-z0-9_]+|(std[a-z]+|string|math|float|limits|assert|errno|ctype|inttypes|time|wchar|signal|setjmp|locale|"
      "uchar|tgmath|fenv|complex)\\.h");
  return std::regex_match(target, name);
}

/// The room of an include, "" for outside libraries.
std::string targetRoom(const std::string& path, const Include& include,
                       const std::function<bool(const std::string&)>& exists) {
  namespace fs = std::filesystem;
  const std::string beside = (fs::path(path).parent_path() / include.target).lexically_normal().generic_string();
  if (include.quoted && exists(beside)) return roomOf(beside);
  // A leaf of a plugin or sample that is named from its own root.
  const std::string own = roomOf(path);
  if (startsWith(own, "plugin:")) {
    const std::string root =
        path.substr(0, path.find("/", std::string("plugins/").size()) + 1);  // "samples/" is as long
    if (exists(root + include.target)) return own;
  }
  const std::string first = include.target.substr(0, include.target.find('/'));
  if (first != include.target && contains(engineRooms(), first) && !exists("shaders/" + include.target)) return first;
  if (startsWith(include.target, "tyndall/")) return "abi";
  if (startsWith(include.target, "shared/")) return "shared";
  if (startsWith(include.target, "lib/")) return "lib";
  if (exists("shaders/" + include.target)) return roomOf("shaders/" + include.target);
  if (startsWith(include.target, "levels/")) return "levels";
  return "";
}

}  // namespace

std::vector<Include> includesOf(const std::string& text) {
  std::string code = text;
  // Comments become blanks of the same number of lines.
  bool block = false, lineComment = false, quote = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code[i] == '\n') {
      lineComment = quote = false;
      continue;
    }
    if (block) {
      if (code.compare(i, 2, "*/") == 0) {
        block = false;
        code[i] = code[i + 1] = ' ';
        ++i;
        continue;
      }
      code[i] = ' ';
    } else if (lineComment) {
      code[i] = ' ';
    } else if (quote) {
      if (code[i] == '\\')
        ++i;
      else if (code[i] == '"')
        quote = false;
    } else if (code[i] == '"') {
      quote = true;
    } else if (code.compare(i, 2, "/*") == 0) {
      block = true;
      code[i] = code[i + 1] = ' ';
      ++i;
    } else if (code.compare(i, 2, "//") == 0) {
      lineComment = true;
      code[i] = ' ';
    }
  }
  std::vector<Include> includes;
  int line = 1;
  std::size_t begin = 0;
  static const std::regex directive("^\\s*#\\s*include\\s*([\"<])([^\">]+)[\">].*");
  while (begin <= code.size()) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    const std::string row = code.substr(begin, end - begin);
    std::smatch match;
    if (row.find("include") != std::string::npos && std::regex_match(row, match, directive))
      includes.push_back({match[2], match[1] == "\"", line});
    begin = end + 1;
    ++line;
  }
  return includes;
}

std::vector<std::string> brokenArrows(const std::string& path, const std::string& text,
                                      const std::function<bool(const std::string&)>& exists) {
  std::vector<std::string> broken;
  const std::string room = roomOf(path);
  if (room.empty() || room == "tests") return broken;
  const std::set<std::string> visible = visibleFrom(room);
  const bool plugin = startsWith(room, "plugin:");
  const bool leaf = plugin || room == "abi" || room == "shared" || room == "lib";
  for (const Include& include : includesOf(text)) {
    const std::string where = path + ":" + std::to_string(include.line) + " includes " + include.target + ": ";
    const std::string target = targetRoom(path, include, exists);
    if (!target.empty()) {
      if (!visible.count(target)) broken.push_back(where + room + " may not see " + target);
      continue;
    }
    if (const Library* library = libraryOf(include.target)) {
      if (!contains(library->rooms, room) && !contains(library->alsoFiles, path))
        broken.push_back(where + library->name + " may not be used in " + room);
      else if (!library->inHeaders && isHeader(path) && path.find("/include/") != std::string::npos)
        broken.push_back(where + library->name + " may not be in a header that others include");
      continue;
    }
    const bool glm = startsWith(include.target, "glm/");
    if (leaf && !isStandard(include.target) && !(glm && room != "abi"))
      broken.push_back(
          where + room +
          " may use only the ABI, shaders/shared, shaders/lib, GLM, the standard library and its own files");
  }
  return broken;
}

std::vector<std::string> brokenArrows(const std::map<std::string, std::string>& tree) {
  const auto exists = [&](const std::string& path) { return tree.count(path) > 0; };
  std::vector<std::string> broken;
  std::map<const Library*, std::vector<std::string>> users;
  for (const auto& [path, text] : tree) {
    for (std::string& line : brokenArrows(path, text, exists)) broken.push_back(std::move(line));
    if (roomOf(path) == "tests") continue;
    for (const Include& include : includesOf(text))
      if (const Library* library = libraryOf(include.target); library && !contains(users[library], path))
        users[library].push_back(path);
  }
  for (const auto& [library, paths] : users) {
    if (library->maxFiles == 0 || paths.size() <= library->maxFiles) continue;
    std::string line =
        std::string(library->name) + " may appear in " + std::to_string(library->maxFiles) + " file, it does in";
    for (const std::string& path : paths) line += " " + path;
    broken.push_back(line);
  }
  return broken;
}

}  // namespace tyndall::arrows
