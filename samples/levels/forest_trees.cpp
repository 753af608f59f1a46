// The forest's kinds of trees.
#include "forest_parts.hpp"
#include "forest_textures.hpp"
#include "trees.hpp"

namespace tyndall::levels::forest {

Trees makeTrees(LevelBuilder& level, const Materials& m) {
  const Coat bark{m.bark, kBarkTile}, white{m.birch, kBarkTile};
  Trees trees;
  trees.full = {broadTree(level, "beech", kBeech, 1, bark, m.leaves),
                spruceTree(level, "spruce", kSpruce, 2, bark, m.needles),
                broadTree(level, "birch", kBirch, 3, white, m.paleLeaves),
                broadTree(level, "oak", kOak, 4, bark, m.leaves),
                broadTree(level, "beech 2", kBeech, 5, bark, m.leaves),
                broadTree(level, "birch 2", kBirch, 6, white, m.paleLeaves)};
  trees.spare = {broadTree(level, "distant beech", kDistantBeech, 7, bark, m.leaves),
                 spruceTree(level, "distant spruce", kDistantSpruce, 8, bark, m.needles)};
  return trees;
}

}  // namespace tyndall::levels::forest
