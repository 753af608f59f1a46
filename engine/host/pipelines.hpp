// Pipelines of a plugin's passes. A pipeline is kept as long as some layout asks for the same one, so that a change of
// size compiles nothing.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gpu/pipeline.hpp"
#include "gpu/shader.hpp"
#include "host/layout.hpp"

namespace tyndall::host {

using PipelinePtr = std::shared_ptr<const gpu::Pipeline>;

class Pipelines {
 public:
  Pipelines(gpu::Device& device, const std::filesystem::path& shaderFolder);

  /// One pipeline per pass (null for caster passes). On an error nothing changes.
  Result<std::vector<PipelinePtr>> of(const Layout& layout);
  /// Recompiles changed shaders. Lines for the log; `changed` says whether any code is new.
  std::vector<std::string> reload(bool& changed);

 private:
  Result<gpu::Pipeline> make(const Layout& layout, const LayoutPass& pass, std::shared_ptr<const gpu::Shader> shader);

  gpu::Device& device_;
  gpu::ShaderFolder shaders_;
  std::shared_ptr<const gpu::Shader> fullScreen_;
  std::map<std::string, PipelinePtr> made_;  ///< by everything a pipeline depends on
};

}  // namespace tyndall::host
