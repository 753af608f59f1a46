// Only the handful of instructions that declare resources is looked at (SPIR-V 1.6 specification, section 3).
#include "spirv_interface.hpp"

#include <algorithm>
#include <map>

namespace tyndall::host {
namespace {

enum Op : std::uint32_t {
  kTypeImage = 25,
  kTypeSampledImage = 27,
  kTypeArray = 28,
  kTypeRuntimeArray = 29,
  kTypeStruct = 30,
  kTypePointer = 32,
  kVariable = 59,
  kDecorate = 71
};
enum Decoration : std::uint32_t { kBufferBlock = 3, kBinding = 33, kDescriptorSet = 34 };
enum StorageClass : std::uint32_t { kUniformConstant = 0, kUniform = 2, kPushConstant = 9, kStorageBuffer = 12 };

struct Type {
  std::uint32_t op = 0, pointee = 0, sampled = 0;
};
struct Variable {
  std::uint32_t pointer = 0, storage = 0, set = 0, binding = 0;
  bool bound = false, bufferBlock = false;
};

struct Module {
  std::map<std::uint32_t, Type> types;
  std::map<std::uint32_t, Variable> variables;  ///< also ids that are only decorated
};

const char* typeName(VkDescriptorType type) {
  switch (type) {
    case VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER: return "a sampled image";
    case VK_DESCRIPTOR_TYPE_STORAGE_IMAGE: return "a storage image";
    case VK_DESCRIPTOR_TYPE_STORAGE_BUFFER: return "a storage buffer";
    case VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER: return "a uniform block";
    default: return "something that is not offered";
  }
}

Result<Module> readModule(std::span<const std::uint32_t> code) {
  if (code.size() < 5 || code[0] != 0x07230203u) return failed("is not SPIR-V");
  Module module;
  for (std::size_t at = 5; at < code.size();) {
    const std::uint32_t words = code[at] >> 16, op = code[at] & 0xffffu;
    if (words == 0 || words > code.size() - at) return failed("is damaged SPIR-V");
    const auto word = [&](std::uint32_t i) { return i < words ? code[at + i] : 0u; };
    switch (op) {
      case kTypeImage: module.types[word(1)] = {op, 0, word(7)}; break;
      case kTypeSampledImage:
      case kTypeArray:
      case kTypeRuntimeArray:
      case kTypeStruct: module.types[word(1)] = {op, 0, 0}; break;
      case kTypePointer: module.types[word(1)] = {op, word(3), 0}; break;
      case kVariable:
        module.variables[word(2)].pointer = word(1);
        module.variables[word(2)].storage = word(3);
        break;
      case kDecorate: {
        Variable& v = module.variables[word(1)];
        if (word(2) == kBinding) v.binding = word(3), v.bound = true;
        if (word(2) == kDescriptorSet) v.set = word(3);
        if (word(2) == kBufferBlock) v.bufferBlock = true;
        break;
      }
      default: break;
    }
    at += words;
  }
  return module;
}

VkDescriptorType descriptorType(const Module& module, const Variable& v) {
  const auto typeOf = [&](std::uint32_t id) {
    const auto found = module.types.find(id);
    return found == module.types.end() ? Type{} : found->second;
  };
  const std::uint32_t pointee = typeOf(v.pointer).pointee;
  const Type type = typeOf(pointee);
  if (v.storage == kUniformConstant && type.op == kTypeSampledImage) return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  if (v.storage == kUniformConstant && type.op == kTypeImage && type.sampled == 2)
    return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  if (v.storage == kStorageBuffer && type.op == kTypeStruct) return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  if (v.storage == kUniform && type.op == kTypeStruct) {
    const auto decorated = module.variables.find(pointee);
    const bool old =
        decorated != module.variables.end() && decorated->second.bufferBlock;  // storage buffers before SPIR-V 1.3
    return old ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

}  // namespace

Result<std::vector<ShaderBinding>> shaderBindings(std::span<const std::uint32_t> code) {
  auto module = readModule(code);
  if (!module) return module.error();
  std::vector<ShaderBinding> bindings;
  for (const auto& [id, v] : module->variables) {
    if (v.pointer == 0) continue;
    if (v.storage == kPushConstant) return failed("declares push constants; the host gives none, take a uniform block");
    if (!v.bound) continue;
    if (v.set != 0)
      return failed("declares binding " + std::to_string(v.binding) + " in set " + std::to_string(v.set) +
                    "; bindings are in set 0");
    bindings.push_back({v.binding, descriptorType(*module, v)});
  }
  return bindings;
}

Result<void> checkShaderBindings(std::span<const std::uint32_t> code, const std::vector<ShaderBinding>& given) {
  auto declared = shaderBindings(code);
  if (!declared) return declared.error();
  for (const ShaderBinding& d : *declared) {
    const auto same =
        std::find_if(given.begin(), given.end(), [&](const ShaderBinding& g) { return g.binding == d.binding; });
    const std::string what = "declares binding " + std::to_string(d.binding) + " as " + typeName(d.type);
    if (same == given.end()) return failed(what + ", which the pass's table lacks");
    if (same->type != d.type) return failed(what + ", but the pass's table gives " + typeName(same->type));
  }
  return {};
}

}  // namespace tyndall::host
