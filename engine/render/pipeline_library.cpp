#include "pipeline_library.hpp"

#include <algorithm>

namespace tyndall::render {

Result<gpu::Pipeline> PipelineLibrary::make(const Recipe& recipe) {
  gpu::GraphicsPipelineDesc desc = recipe.desc;
  Result<std::shared_ptr<const gpu::Shader>> shader = shaders_.get(recipe.vertex);
  if (!shader) return shader.error();
  desc.vertex = *shader;
  if (!recipe.fragment.empty()) {
    shader = shaders_.get(recipe.fragment);
    if (!shader) return shader.error();
    desc.fragment = *shader;
  }
  return gpu::createPipeline(device_, desc);
}

Result<const gpu::Pipeline*> PipelineLibrary::get(const Recipe& recipe) {
  const auto known = entries_.find(recipe.desc.name);
  if (known != entries_.end()) return &known->second.pipeline;
  Result<gpu::Pipeline> made = make(recipe);
  if (!made) return made.error();
  return &entries_.emplace(recipe.desc.name, Entry{recipe, made.take()}).first->second.pipeline;
}

std::vector<std::string> PipelineLibrary::reload() {
  const gpu::ShaderFolder::Reload reloaded = shaders_.reloadChanged();
  std::vector<std::string> lines;
  for (const std::string& name : reloaded.changed) lines.push_back(name + ": reloaded");
  for (const Error& error : reloaded.errors) lines.push_back(error.message);
  const auto changed = [&](const std::string& name) {
    return std::find(reloaded.changed.begin(), reloaded.changed.end(), name) != reloaded.changed.end();
  };
  for (auto& [name, entry] : entries_) {
    if (!changed(entry.recipe.vertex) && !changed(entry.recipe.fragment)) continue;
    Result<gpu::Pipeline> made = make(entry.recipe);
    if (made) {
      entry.pipeline = made.take();
    } else {
      lines.push_back(made.error().message);
    }
  }
  return lines;
}

}  // namespace tyndall::render
