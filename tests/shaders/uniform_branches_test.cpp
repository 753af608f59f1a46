// No branch and no loop of a shader hangs on members of uniform blocks alone: lavapipe (Mesa 22.3,
// update_inline_shader_state() in lvp_execute.c) would compile the shader anew for their values, at draws and
// dispatches. shaders/engine/include/opaque.glsl and plugins/volumetrics/stages/opaque.glsl hide such conditions.
// Looked for here as that driver does, in the SPIR-V with functions inlined and local variables gone.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spirv-tools/optimizer.hpp>
#include <spirv/unified1/spirv.hpp>

namespace tyndall {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::uint32_t>;

struct Instruction {
  spv::Op op = spv::OpNop;
  Words words;  ///< after the first, which holds the opcode
  Words ids;    ///< operands that are ids, without type and result
  std::uint32_t type = 0, result = 0;
};

Words read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), {});
  Words words(bytes.size() / 4);
  std::copy(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(words.size() * 4),
            reinterpret_cast<char*>(words.data()));
  return words;
}

/// One function, no local variable that is not an array read by a variable index.
Words flattened(const Words& code) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);  // scalar block layout
  optimizer.RegisterPass(spvtools::CreateMergeReturnPass())
      .RegisterPass(spvtools::CreateInlineExhaustivePass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreateScalarReplacementPass(0))
      .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
      .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateScalarReplacementPass(0))
      .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
      .RegisterPass(spvtools::CreateSSARewritePass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass())
      .RegisterPass(spvtools::CreateSimplificationPass());
  Words made;
  return optimizer.Run(code.data(), code.size(), &made, options) ? made : Words();
}

class Module {
 public:
  explicit Module(const Words& code) {
    const spvtools::Context context(SPV_ENV_VULKAN_1_3);
    const auto take = [](void* self, const spv_parsed_instruction_t* parsed) {
      Instruction i;
      i.op = static_cast<spv::Op>(parsed->opcode);
      i.words.assign(parsed->words + 1, parsed->words + parsed->num_words);
      i.type = parsed->type_id, i.result = parsed->result_id;
      for (std::uint16_t o = 0; o < parsed->num_operands; ++o)
        if (parsed->operands[o].type == SPV_OPERAND_TYPE_ID) i.ids.push_back(parsed->words[parsed->operands[o].offset]);
      static_cast<Module*>(self)->instructions_.push_back(i);
      return SPV_SUCCESS;
    };
    good_ = spvBinaryParse(context.CContext(), this, code.data(), code.size(), nullptr, take, nullptr) == SPV_SUCCESS;
    for (std::size_t i = 0; i < instructions_.size(); ++i)
      if (instructions_[i].result != 0) defined_[instructions_[i].result] = i;
  }
  bool good() const { return good_; }

  /// What each branch or loop that hangs on uniform blocks alone reads, in words.
  std::vector<std::string> branches() {
    std::vector<std::string> found;
    for (const Instruction& branch : instructions_) {
      if (branch.op != spv::OpBranchConditional && branch.op != spv::OpSwitch) continue;
      reads_.clear();
      if (const auto condition = onlyUniforms(branch.ids[0], {}); condition && *condition) {
        found.push_back("a branch on " + reads());
        continue;
      }
      // The end of a loop: a counter against what is uniform.
      const Instruction& compare = at(branch.ids[0]);
      if (compare.ids.size() != 2) continue;
      for (const std::size_t side : {0u, 1u}) {
        reads_.clear();
        if (at(compare.ids[side]).op != spv::OpPhi) continue;
        if (const auto limit = onlyUniforms(compare.ids[1 - side], {}); limit && *limit)
          found.push_back("the length of a loop, " + reads());
      }
    }
    return found;
  }

 private:
  const Instruction& at(std::uint32_t id) const {
    static const Instruction none;
    const auto i = defined_.find(id);
    return i == defined_.end() ? none : instructions_[i->second];
  }
  static bool isConstant(const Instruction& i) {
    return (i.op >= spv::OpConstantTrue && i.op <= spv::OpConstantNull) ||
           (i.op >= spv::OpSpecConstantTrue && i.op <= spv::OpSpecConstantOp);
  }

  /// The uniform block of a pointer whose indices are constants, or 0.
  std::uint32_t blockOf(std::uint32_t pointer) const {
    const Instruction& i = at(pointer);
    if (i.op == spv::OpVariable) {
      const auto storage = static_cast<spv::StorageClass>(i.words[2]);
      return storage == spv::StorageClassUniform || storage == spv::StorageClassPushConstant ? pointer : 0;
    }
    if (i.op != spv::OpAccessChain && i.op != spv::OpInBoundsAccessChain) return 0;
    for (std::size_t k = 1; k < i.ids.size(); ++k)
      if (!isConstant(at(i.ids[k]))) return 0;
    return blockOf(i.ids[0]);
  }

  /// Whether an expression reads uniform blocks; nothing if it reads something else too. A value that branches give it
  /// counts as what they give.
  std::optional<bool> onlyUniforms(std::uint32_t id, std::set<std::uint32_t> above) {
    const Instruction& i = at(id);
    if (isConstant(i)) return false;
    if (!above.insert(id).second) return std::nullopt;  // a counter
    if (i.op == spv::OpLoad) {
      if (blockOf(i.ids[0]) == 0) return std::nullopt;
      reads_.insert(nameOf(i.ids[0]));
      return true;
    }
    const bool plain = i.op == spv::OpPhi || i.op == spv::OpExtInst ||
                       (i.op >= spv::OpVectorExtractDynamic && i.op <= spv::OpTranspose) ||
                       (i.op >= spv::OpConvertFToU && i.op <= spv::OpBitcast) ||
                       (i.op >= spv::OpSNegate && i.op <= spv::OpBitCount);
    if (!plain || i.ids.empty()) return std::nullopt;
    bool any = false;
    for (std::size_t k = i.op == spv::OpExtInst ? 1 : 0; k < i.ids.size(); k += i.op == spv::OpPhi ? 2 : 1) {
      const auto part = onlyUniforms(i.ids[k], above);
      if (!part) return std::nullopt;
      any = any || *part;
    }
    return any;
  }

  std::string debugName(spv::Op op, std::uint32_t id, std::uint32_t member) const {
    for (const Instruction& i : instructions_) {
      if (i.op != op || i.words[0] != id || (op == spv::OpMemberName && i.words[1] != member)) continue;
      return reinterpret_cast<const char*>(&i.words[op == spv::OpMemberName ? 2 : 1]);
    }
    return "?";
  }
  /// The names of the members that a pointer goes through.
  std::string nameOf(std::uint32_t pointer) const {
    const Instruction& i = at(pointer);
    if (i.op == spv::OpVariable) return debugName(spv::OpName, at(i.type).words[2], 0);
    std::string name = nameOf(i.ids[0]);
    std::uint32_t type = at(at(i.ids[0]).type).words[2];
    for (std::size_t k = 1; k < i.ids.size(); ++k) {
      const Instruction& holder = at(type);
      const std::uint32_t index = at(i.ids[k]).words.size() > 2 ? at(i.ids[k]).words[2] : 0;
      if (holder.op == spv::OpTypeStruct) {
        name += "." + debugName(spv::OpMemberName, type, index);
        type = holder.words[1 + index];
      } else {
        name += "[" + std::to_string(index) + "]";
        type = holder.words[1];
      }
    }
    return name;
  }
  std::string reads() const {
    std::string text;
    for (const std::string& name : reads_) text += (text.empty() ? "" : " and ") + name;
    return text;
  }

  std::vector<Instruction> instructions_;
  std::map<std::uint32_t, std::size_t> defined_;
  std::set<std::string> reads_;
  bool good_ = false;
};

std::vector<std::string> branchesOf(const fs::path& file) {
  const Words code = flattened(read(file));
  EXPECT_FALSE(code.empty()) << file;
  Module module_(code);
  EXPECT_TRUE(module_.good()) << file;
  return module_.branches();
}

TEST(UniformBranches, AreFoundWhereTheyAre) {
  EXPECT_THAT(branchesOf(fs::path(TYNDALL_TEST_SHADERS) / "branches.comp.spv"),
              testing::UnorderedElementsAre("a branch on Block.mode", "a branch on Block.range",
                                            "a branch on Block.table[2]", "the length of a loop, Block.count"));
}

TEST(UniformBranches, NoShaderHasOne) {
  std::size_t seen = 0;
  for (const char* folder : {"shaders", "plugins"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(TYNDALL_BIN_DIR) / folder)) {
      if (entry.path().extension() != ".spv") continue;
      ++seen;
      EXPECT_THAT(branchesOf(entry.path()), testing::IsEmpty())
          << entry.path() << ": hide what it hangs on with opaque()";
    }
  EXPECT_GT(seen, 30u);
}

}  // namespace
}  // namespace tyndall
