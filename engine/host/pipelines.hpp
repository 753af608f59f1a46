// Pipelines of a plugin's passes. A pipeline is kept as long as some layout asks for the same one, so that a change of
// size compiles nothing.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/pipeline.hpp"
#include "gpu/shader.hpp"
#include "host/layout.hpp"

namespace tyndall::host {

using PipelinePtr = std::shared_ptr<const gpu::Pipeline>;

/// All that a pass's pipeline is made from. Points into no layout, so that another thread can make it.
struct PipelinePlan {
  std::string key;  ///< equal for equal pipelines
  bool graphics = false;
  gpu::ComputePipelineDesc compute;
  gpu::GraphicsPipelineDesc fullScreen;
};
Result<gpu::Pipeline> makePipeline(gpu::Device& device, const PipelinePlan& plan);

class Pipelines {
 public:
  Pipelines(gpu::Device& device, const std::filesystem::path& shaderFolder);

  /// What each pass needs (nothing: caster passes). Loads shaders and checks them against the tables.
  Result<std::vector<std::optional<PipelinePlan>>> plan(const Layout& layout);
  bool has(const std::string& key) const { return made_.contains(key); }
  PipelinePtr find(const std::string& key) const;  ///< null if it is not there
  /// One pipeline per pass (null for caster passes). On an error nothing changes.
  Result<std::vector<PipelinePtr>> of(const std::vector<std::optional<PipelinePlan>>& plans);
  /// The same for plans whose missing pipelines were made elsewhere. `fresh` may lack those that has() knows.
  std::vector<PipelinePtr> adopt(const std::vector<std::optional<PipelinePlan>>& plans,
                                 std::map<std::string, PipelinePtr> fresh);
  /// Recompiles changed shaders. Lines for the log; `changed` says whether any code is new.
  std::vector<std::string> reload(bool& changed);

 private:
  Result<PipelinePlan> planOf(const Layout& layout, const LayoutPass& pass,
                              std::shared_ptr<const gpu::Shader> shader) const;

  gpu::Device& device_;
  gpu::ShaderFolder shaders_;
  std::shared_ptr<const gpu::Shader> fullScreen_;
  std::map<std::string, PipelinePtr> made_;  ///< by everything a pipeline depends on
};

}  // namespace tyndall::host
