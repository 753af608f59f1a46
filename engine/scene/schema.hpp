// A small table-driven check of JSON against the glTF 2.0 schema. tinygltf reads wrong types as defaults, casts
// without looking and follows indices unchecked; what reaches it has passed here first.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "import_log.hpp"

namespace tyndall::scene {

using Json = nlohmann::json;

enum class Kind {
  kAny,  ///< taken as it is; whoever reads it checks it
  kBoolean,
  kString,
  kNumber,
  kInteger,
  kIndex,
  kNumbers,
  kIndices,
  kStrings,
  kAttributes,
  kObject,
  kObjects
};

struct Schema;

struct Property {
  const char* key = "";
  Kind kind = Kind::kObject;
  bool required = false;
  double low = -std::numeric_limits<float>::max();  ///< of numbers, integers and the elements of arrays
  double high = std::numeric_limits<float>::max();
  bool free = false;         ///< kObject: a value of another type is left out (glTF's "extras" may be anything)
  bool clamp = false;        ///< out of range is repaired with a warning instead of refused
  std::size_t minItems = 0;  ///< of arrays
  std::size_t maxItems = std::numeric_limits<std::size_t>::max();
  const char* array = nullptr;     ///< kIndex, kIndices, kAttributes: the array of the document that is pointed into
  const char* choices = nullptr;   ///< kString, kInteger: allowed values, separated by '|'
  const Schema* object = nullptr;  ///< kObject, kObjects
  /// kObjects: JSON of what stands for an element that is broken, so that the others keep their indices; "" leaves it
  /// out; null: the whole array is broken with it.
  const char* standIn = nullptr;
};

struct Schema {
  std::vector<Property> properties;
};

/// A copy of `value` with only the properties of `schema`, each of the right type and in range; integers written as
/// floats become integers. What is broken is counted in `warnings` with its path, such as "nodes[3].mesh is 7; there
/// are 5 meshes": an optional property is as if it were not there, an index in a list is left out, an element of an
/// array becomes its stand-in. Refuses where a required property is broken that nothing can stand in for. `document` is
/// where indices point into; `path` names `value` and is empty for the document itself.
Json checked(const Json& value, const Schema& schema, const Json& document, const std::string& path,
             Warnings& warnings);

/// What the importer reads of a glTF document.
const Schema& gltfSchema();

}  // namespace tyndall::scene
