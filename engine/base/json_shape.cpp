#include "base/json_shape.hpp"

namespace tyndall {

std::string jsonShapeProblem(std::string_view json, std::size_t maxValues) {
  std::size_t depth = 0, values = 1;
  for (std::size_t i = 0; i < json.size(); ++i) {
    switch (json[i]) {
      case '"':
        // Data URIs make strings of many megabytes: skip to the next unescaped quotation mark.
        for (++i; i < json.size() && json[i] != '"'; ++i)
          if (json[i] == '\\') ++i;
        break;
      case '{':
      case '[':
        ++values;
        if (++depth > kMaxJsonDepth) return "nests deeper than " + std::to_string(kMaxJsonDepth) + " levels";
        break;
      case '}':
      case ']':
        if (depth > 0) --depth;
        break;
      case ',': ++values; break;
      default: break;
    }
    if (values > maxValues) return "has more than " + std::to_string(maxValues) + " values";
  }
  return {};
}

}  // namespace tyndall
