// The frame's pipelines, made at first use and remade when their shaders change.
#pragma once

#include <cstdint>
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

/// The same for a compute pipeline. Its names are apart from those of graphics pipelines.
struct ComputeRecipe {
  gpu::ComputePipelineDesc desc;
  std::string shader;  ///< "moments_blur.comp"
};

class PipelineLibrary {
 public:
  PipelineLibrary(gpu::Device& device, const std::filesystem::path& shaderFolder)
      : device_(device), shaders_(shaderFolder) {}

  /// Begins a frame: where there are many pipelines, those that no frame of late has asked for go; those of an earlier scene soon.
  void beginFrame();
  void sceneChanged() { sceneFrame_ = frame_; }

  /// The pointer stays good until the next frame begins; reload() swaps what it points to.
  Result<const gpu::Pipeline*> get(const Recipe& recipe);
  Result<const gpu::Pipeline*> get(const ComputeRecipe& recipe);

  /// Recompiles changed shaders and rebuilds the pipelines that use them; what fails keeps its last good pipeline. One
  /// line per shader changed or broken.
  std::vector<std::string> reload();

  std::size_t size() const { return graphics_.size() + compute_.size(); }

 private:
  Result<gpu::Pipeline> make(const Recipe& recipe);
  Result<gpu::Pipeline> make(const ComputeRecipe& recipe);

  template <class R>
  struct Entry {
    R recipe;
    gpu::Pipeline pipeline;
    std::uint64_t asked = 0;  ///< the last frame that did
  };
  template <class R>
  using Entries = std::map<std::string, Entry<R>>;
  template <class R>
  Result<const gpu::Pipeline*> find(Entries<R>& entries, const R& recipe);
  template <class R>
  void remake(Entries<R>& entries, const std::vector<std::string>& changed, std::vector<std::string>& lines);

  template <class R>
  void letGoOfOld(Entries<R>& entries);

  gpu::Device& device_;
  gpu::ShaderFolder shaders_;
  std::uint64_t frame_ = 0, sceneFrame_ = 0;
  Entries<Recipe> graphics_;
  Entries<ComputeRecipe> compute_;
};

}  // namespace tyndall::render
