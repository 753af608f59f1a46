// The frame's pipelines, made at first use and remade when their shaders change.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
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

  /// Begins a frame: where there are many pipelines, those that no frame of late has asked for go; those of an earlier
  /// scene soon.
  void beginFrame();
  void sceneChanged() { sceneFrame_ = frame_; }

  /// The pointer stays good until the next frame begins; reload() swaps what it points to.
  Result<const gpu::Pipeline*> get(const Recipe& recipe);
  Result<const gpu::Pipeline*> get(const ComputeRecipe& recipe);

  /// Recompiles changed shaders and rebuilds the pipelines that use them; what fails keeps its last good pipeline. One
  /// line per shader changed or broken.
  std::vector<std::string> reload();

  /// Pipelines by name that another library has made, or is to leave out.
  struct Names {
    std::set<std::string> graphics, compute;
  };
  struct Made {
    std::vector<std::pair<Recipe, gpu::Pipeline>> graphics;
    std::vector<std::pair<ComputeRecipe, gpu::Pipeline>> compute;
  };
  Names names() const;
  /// This library's recipes, but for those that are `known`, as pipelines of another device.
  Result<Made> makeFor(gpu::Device& device, const Names& known);
  /// Takes what is new here.
  void adopt(Made made);

  std::size_t size() const { return graphics_.size() + compute_.size(); }

 private:
  Result<gpu::Pipeline> make(gpu::Device& device, const Recipe& recipe);
  Result<gpu::Pipeline> make(gpu::Device& device, const ComputeRecipe& recipe);

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
  template <class R>
  Result<void> makeAll(const Entries<R>& entries, gpu::Device& device, const std::set<std::string>& known,
                       std::vector<std::pair<R, gpu::Pipeline>>& made);
  template <class R>
  void adoptAll(Entries<R>& entries, std::vector<std::pair<R, gpu::Pipeline>> made);

  gpu::Device& device_;
  gpu::ShaderFolder shaders_;
  std::uint64_t frame_ = 0, sceneFrame_ = 0;
  Entries<Recipe> graphics_;
  Entries<ComputeRecipe> compute_;
};

}  // namespace tyndall::render
