// Trees: broad-leaved ones with a crown like an egg, and spruces. They stand on y = 0 about the origin.
#pragma once

#include "props.hpp"

namespace tyndall::levels {

struct TreeKind {
  float height, trunk;  // metres; radius at breast height
  float crownFrom;      // share of the height where branches begin
  float crownRadius;
  int branches, twigs, cards;  // branches; twigs a branch; cards a twig
  float cardSize, droop;       // metres; how much leaves hang
  int trunkSides;
  bool twigWood = true;  // twigs have wood of their own; from afar only their leaves are seen
};

std::int32_t broadTree(LevelBuilder& level, const std::string& name, const TreeKind& kind, std::uint64_t seed,
                       const Coat& bark, std::int32_t leaves);
std::int32_t spruceTree(LevelBuilder& level, const std::string& name, const TreeKind& kind, std::uint64_t seed,
                        const Coat& bark, std::int32_t needles);

inline constexpr TreeKind kBeech{.height = 13.5f,
                                 .trunk = 0.30f,
                                 .crownFrom = 0.30f,
                                 .crownRadius = 4.4f,
                                 .branches = 20,
                                 .twigs = 5,
                                 .cards = 5,
                                 .cardSize = 0.95f,
                                 .droop = 0.15f,
                                 .trunkSides = 12};
inline constexpr TreeKind kOak{.height = 10.5f,
                               .trunk = 0.36f,
                               .crownFrom = 0.26f,
                               .crownRadius = 5.0f,
                               .branches = 18,
                               .twigs = 6,
                               .cards = 5,
                               .cardSize = 0.9f,
                               .droop = 0.0f,
                               .trunkSides = 12};
inline constexpr TreeKind kBirch{.height = 12.0f,
                                 .trunk = 0.15f,
                                 .crownFrom = 0.34f,
                                 .crownRadius = 2.7f,
                                 .branches = 18,
                                 .twigs = 4,
                                 .cards = 5,
                                 .cardSize = 0.75f,
                                 .droop = 0.55f,
                                 .trunkSides = 9};
inline constexpr TreeKind kSpruce{.height = 16.0f,
                                  .trunk = 0.24f,
                                  .crownFrom = 0.10f,
                                  .crownRadius = 3.0f,
                                  .branches = 30,
                                  .twigs = 7,
                                  .cards = 0,
                                  .cardSize = 0,
                                  .droop = 0.35f,
                                  .trunkSides = 9};

/// From afar: fewer branches and cards, larger cards, no wood in the twigs.
inline constexpr TreeKind kDistantBeech{.height = 13.5f,
                                        .trunk = 0.30f,
                                        .crownFrom = 0.30f,
                                        .crownRadius = 4.4f,
                                        .branches = 14,
                                        .twigs = 3,
                                        .cards = 3,
                                        .cardSize = 1.6f,
                                        .droop = 0.15f,
                                        .trunkSides = 7,
                                        .twigWood = false};
inline constexpr TreeKind kDistantSpruce{.height = 16.0f,
                                         .trunk = 0.24f,
                                         .crownFrom = 0.10f,
                                         .crownRadius = 3.4f,
                                         .branches = 18,
                                         .twigs = 5,
                                         .cards = 0,
                                         .cardSize = 0,
                                         .droop = 0.35f,
                                         .trunkSides = 6,
                                         .twigWood = false};

}  // namespace tyndall::levels
