// What JSON may look like before a library is asked to read it: none of ours nests deep, and recursion over what nests
// a hundred thousand levels deep ends a program.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tyndall {

/// How deep JSON may nest, wherever it is read (levels reach 7, "extras" some more; results 6).
inline constexpr std::size_t kMaxJsonDepth = 128;

/// What is wrong with the shape of `json`, "nests deeper than 128 levels" or "has more than N values"; empty if nothing
/// is. Counts brackets outside strings: says nothing of whether it is JSON at all.
std::string jsonShapeProblem(std::string_view json, std::size_t maxValues = ~std::size_t{0});

}  // namespace tyndall
