#include "pipeline_library.hpp"

#include <algorithm>

namespace tyndall::render {
namespace {

// A level's materials ask for a dozen or two; a user who goes through levels and settings, for hundreds, megabytes each
// on some drivers.
constexpr std::size_t kKept = 16;
constexpr std::uint64_t kKeptFrames = 600, kKeptAfterScene = 20;

}  // namespace

void PipelineLibrary::beginFrame() {
  ++frame_;
  letGoOfOld(graphics_);
  letGoOfOld(compute_);
}

template <class R>
void PipelineLibrary::letGoOfOld(Entries<R>& entries) {
  if (entries.size() <= kKept) return;
  std::erase_if(entries, [this](const auto& entry) {
    const std::uint64_t asked = entry.second.asked;
    return asked + kKeptFrames < frame_ || (asked <= sceneFrame_ && sceneFrame_ + kKeptAfterScene < frame_);
  });
}

Result<gpu::Pipeline> PipelineLibrary::make(gpu::Device& device, const Recipe& recipe) {
  gpu::GraphicsPipelineDesc desc = recipe.desc;
  Result<std::shared_ptr<const gpu::Shader>> shader = shaders_.get(recipe.vertex);
  if (!shader) return shader.error();
  desc.vertex = *shader;
  if (!recipe.fragment.empty()) {
    shader = shaders_.get(recipe.fragment);
    if (!shader) return shader.error();
    desc.fragment = *shader;
  }
  return gpu::createPipeline(device, desc);
}

Result<gpu::Pipeline> PipelineLibrary::make(gpu::Device& device, const ComputeRecipe& recipe) {
  gpu::ComputePipelineDesc desc = recipe.desc;
  Result<std::shared_ptr<const gpu::Shader>> shader = shaders_.get(recipe.shader);
  if (!shader) return shader.error();
  desc.shader = *shader;
  return gpu::createPipeline(device, desc);
}

template <class R>
Result<const gpu::Pipeline*> PipelineLibrary::find(Entries<R>& entries, const R& recipe) {
  auto entry = entries.find(recipe.desc.name);
  if (entry == entries.end()) {
    Result<gpu::Pipeline> made = make(device_, recipe);
    if (!made) return made.error();
    entry = entries.emplace(recipe.desc.name, Entry<R>{recipe, made.take()}).first;
  }
  entry->second.asked = frame_;
  return &entry->second.pipeline;
}

Result<const gpu::Pipeline*> PipelineLibrary::get(const Recipe& recipe) { return find(graphics_, recipe); }
Result<const gpu::Pipeline*> PipelineLibrary::get(const ComputeRecipe& recipe) { return find(compute_, recipe); }

namespace {

bool usesAny(const Recipe& recipe, const std::vector<std::string>& shaders) {
  return std::find(shaders.begin(), shaders.end(), recipe.vertex) != shaders.end() ||
         std::find(shaders.begin(), shaders.end(), recipe.fragment) != shaders.end();
}
bool usesAny(const ComputeRecipe& recipe, const std::vector<std::string>& shaders) {
  return std::find(shaders.begin(), shaders.end(), recipe.shader) != shaders.end();
}

}  // namespace

template <class R>
void PipelineLibrary::remake(Entries<R>& entries, const std::vector<std::string>& changed,
                             std::vector<std::string>& lines) {
  for (auto& [name, entry] : entries) {
    if (!usesAny(entry.recipe, changed)) continue;
    Result<gpu::Pipeline> made = make(device_, entry.recipe);
    if (made) {
      entry.pipeline = made.take();
    } else {
      lines.push_back(made.error().message);
    }
  }
}

PipelineLibrary::Names PipelineLibrary::names() const {
  Names names;
  for (const auto& [name, entry] : graphics_) names.graphics.insert(name);
  for (const auto& [name, entry] : compute_) names.compute.insert(name);
  return names;
}

template <class R>
Result<void> PipelineLibrary::makeAll(const Entries<R>& entries, gpu::Device& device,
                                      const std::set<std::string>& known,
                                      std::vector<std::pair<R, gpu::Pipeline>>& made) {
  for (const auto& [name, entry] : entries) {
    if (known.contains(name)) continue;
    Result<gpu::Pipeline> pipeline = make(device, entry.recipe);
    if (!pipeline) return pipeline.error();
    made.emplace_back(entry.recipe, pipeline.take());
  }
  return {};
}

Result<PipelineLibrary::Made> PipelineLibrary::makeFor(gpu::Device& device, const Names& known) {
  Made made;
  if (auto done = makeAll(graphics_, device, known.graphics, made.graphics); !done) return done.error();
  if (auto done = makeAll(compute_, device, known.compute, made.compute); !done) return done.error();
  return made;
}

template <class R>
void PipelineLibrary::adoptAll(Entries<R>& entries, std::vector<std::pair<R, gpu::Pipeline>> made) {
  for (auto& [recipe, pipeline] : made)
    entries.try_emplace(recipe.desc.name, Entry<R>{recipe, std::move(pipeline), frame_});
}

void PipelineLibrary::adopt(Made made) {
  adoptAll(graphics_, std::move(made.graphics));
  adoptAll(compute_, std::move(made.compute));
}

std::vector<std::string> PipelineLibrary::reload() {
  const gpu::ShaderFolder::Reload reloaded = shaders_.reloadChanged();
  std::vector<std::string> lines;
  for (const std::string& name : reloaded.changed) lines.push_back(name + ": reloaded");
  for (const Error& error : reloaded.errors) lines.push_back(error.message);
  remake(graphics_, reloaded.changed, lines);
  remake(compute_, reloaded.changed, lines);
  return lines;
}

}  // namespace tyndall::render
