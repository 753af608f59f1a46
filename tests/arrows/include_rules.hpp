// Reads #include lines and says which arrow is broken.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tyndall::arrows {

struct Include {
  std::string target;  ///< what stands between the quotes or brackets
  bool quoted = false;
  int line = 0;
};

/// Every #include of a source text; those in comments do not count.
std::vector<Include> includesOf(const std::string& text);

/// What is wrong with one file, one line each, such as
/// "engine/gpu/x.cpp:3 includes scene/scene.hpp: gpu may not see scene". `exists` tells whether a path relative to the
/// project's root is a file (for includes that are relative to the including file).
std::vector<std::string> brokenArrows(const std::string& path, const std::string& text,
                                      const std::function<bool(const std::string&)>& exists);

/// The same for a whole tree: path -> text. Adds the rules about the number of files, such as "one file of scene".
std::vector<std::string> brokenArrows(const std::map<std::string, std::string>& tree);

}  // namespace tyndall::arrows
