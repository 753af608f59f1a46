// The frame's pipelines, made at first use and remade when their shaders change.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "gpu/pipeline.hpp"

namespace tyndall::render {

/// A pipeline whose shaders are named rather than loaded. `desc.name` identifies it: equal names must mean equal
/// recipes.
struct Recipe {
  gpu::GraphicsPipelineDesc desc;
  std::string vertex, fragment;  ///< "gbuffer.frag"; fragment may be empty
};

class PipelineLibrary {
 public:
  PipelineLibrary(gpu::Device& device, const std::filesystem::path& shaderFolder)
      : device_(device), shaders_(shaderFolder) {}

  /// The pointer stays good for the library's life; reload() swaps what it points to.
  Result<const gpu::Pipeline*> get(const Recipe& recipe);

  /// Recompiles changed shaders and rebuilds the pipelines that use them; what fails keeps its last good pipeline. One
  /// line per shader changed or broken.
  std::vector<std::string> reload();

 private:
  Result<gpu::Pipeline> make(const Recipe& recipe);

  struct Entry {
    Recipe recipe;
    gpu::Pipeline pipeline;
  };
  gpu::Device& device_;
  gpu::ShaderFolder shaders_;
  std::map<std::string, Entry> entries_;
};

}  // namespace tyndall::render
