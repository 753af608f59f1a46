// Which passes run, how long resources live, and what is wrong with a declaration.
#include <algorithm>

#include "graph_plan.hpp"

namespace tyndall::render::plan {

std::string findMistake(const Input& input) {
  std::vector<bool> hasContents(input.resources.size());
  for (std::size_t i = 0; i < input.resources.size(); ++i) {
    const ResourceInput& resource = input.resources[i];
    hasContents[i] = resource.imported && (resource.isBuffer || resource.layoutBefore != VK_IMAGE_LAYOUT_UNDEFINED);
    if (resource.hostVisible && !resource.imported)
      return "buffer '" + resource.name +
             "' is transient and host-visible: frames overlap, so import one per frame in flight";
  }
  for (const PassInput& pass : input.passes) {
    std::vector<std::uint32_t> seen;
    for (const ResourceUse& use : pass.uses) {
      if (use.resource >= input.resources.size())
        return "pass '" + pass.name + "' uses resource " + std::to_string(use.resource) +
               ", which this graph does not have";
      const ResourceInput& resource = input.resources[use.resource];
      const UseInfo info = useInfo(use.use);
      const auto mistake = [&](const char* what) {
        return "pass '" + pass.name + "', '" + resource.name + "' as " + useName(use.use) + ": " + what;
      };
      if (std::find(seen.begin(), seen.end(), use.resource) != seen.end())
        return mistake("a pass uses a resource in one way only");
      seen.push_back(use.resource);
      if (resource.isBuffer ? info.bufferUsage == 0 : info.layout == VK_IMAGE_LAYOUT_UNDEFINED)
        return mistake(resource.isBuffer ? "not a use of buffers" : "not a use of images");
      if (info.reads && !hasContents[use.resource]) return mistake("reads what nobody wrote");
    }
    for (const ResourceUse& use : pass.uses)
      if (writes(use.use)) hasContents[use.resource] = true;
  }
  return {};
}

std::vector<bool> cull(const Input& input) {
  std::vector<bool> kept(input.passes.size());
  std::vector<bool> needed(input.resources.size());  // contents at this point of the backward walk
  for (std::size_t p = input.passes.size(); p-- > 0;) {
    const PassInput& pass = input.passes[p];
    bool keep = pass.keep;
    for (const ResourceUse& use : pass.uses)
      keep = keep || (writes(use.use) && (needed[use.resource] || input.resources[use.resource].imported));
    if (!keep) continue;
    kept[p] = true;
    for (const ResourceUse& use : pass.uses) {
      const UseInfo info = useInfo(use.use);
      if (info.replaces && input.resources[use.resource].singleSubresource) needed[use.resource] = false;
      if (info.reads) needed[use.resource] = true;
    }
  }
  return kept;
}

std::vector<Life> lives(const Input& input, const std::vector<bool>& kept) {
  std::vector<Life> result(input.resources.size());
  for (std::uint32_t p = 0; p < input.passes.size(); ++p) {
    if (!kept[p]) continue;
    for (const ResourceUse& use : input.passes[p].uses) {
      Life& life = result[use.resource];
      life.first = std::min(life.first, p);
      life.last = std::max(life.last, p);
    }
  }
  return result;
}

}  // namespace tyndall::render::plan
