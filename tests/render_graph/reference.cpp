// Values as hashes: a pass writes a hash of itself, of all that it reads, and of what it leaves of the old contents.
#include "simulator.hpp"

namespace tyndall::render::test {

std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = a * 0x9E3779B97F4A7C15ull + b + 0x632BE59BD9B4E019ull;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
  return (x ^ (x >> 31)) | 1;  // never 0, which means undefined
}

std::uint64_t seenBy(const plan::Input& input, std::uint32_t pass, const std::vector<std::uint64_t>& contents) {
  std::uint64_t seen = 1;
  for (const plan::ResourceUse& use : input.passes[pass].uses)
    if (meaningOf(use.use, input.resources[use.resource].isBuffer).needsContents)
      seen = mix(seen, contents[use.resource]);
  return seen;
}

std::uint64_t written(const plan::Input& input, std::uint32_t pass, const plan::ResourceUse& use, std::uint64_t seen,
                      std::uint64_t before) {
  const plan::ResourceInput& resource = input.resources[use.resource];
  const bool all = meaningOf(use.use, resource.isBuffer).replacesAll && resource.singleSubresource;
  return mix(mix(mix(pass + 1, use.resource), seen), all ? 0 : before);
}

std::vector<std::uint64_t> initialContents(const plan::Input& input) {
  std::vector<std::uint64_t> contents(input.resources.size());
  for (std::uint32_t r = 0; r < contents.size(); ++r)
    if (input.resources[r].imported) contents[r] = mix(77, r);
  return contents;
}

Reference reference(const plan::Input& input, std::vector<std::uint64_t> contents, std::uint32_t changed) {
  for (std::uint32_t r = 0; r < contents.size(); ++r) {
    const plan::ResourceInput& resource = input.resources[r];
    const bool lost = !resource.imported || (!resource.isBuffer && resource.layoutBefore == VK_IMAGE_LAYOUT_UNDEFINED);
    if (lost) contents[r] = 0;
  }
  Reference result;
  for (std::uint32_t p = 0; p < input.passes.size(); ++p) {
    result.seen.push_back(seenBy(input, p, contents));
    const std::uint64_t value = p == changed ? mix(result.seen[p], 99) : result.seen[p];
    for (const plan::ResourceUse& use : input.passes[p].uses)
      if (meaningOf(use.use, input.resources[use.resource].isBuffer).writes)
        contents[use.resource] = written(input, p, use, value, contents[use.resource]);
  }
  result.contents = std::move(contents);
  return result;
}

}  // namespace tyndall::render::test
