// The window of a search through a row's sorted depths: which ranks each level leaves, and what is known to be blocked.
// Knows the maps by their roles (TY_VIEW_WALK_RANKS and after it), no technique by name.
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "research_context.hpp"
#include "row_walk.hpp"

namespace tyndall::editor {

class WalkView {
 public:
  bool open = false;

  static bool offered(const ResearchContext& context) { return !context.viewOf(render::ViewRole::kWalkRanks).empty(); }
  /// Views that are needed of a frame. `rows`: slices and columns of the maps, 0 while they are not known.
  std::vector<app::ViewRequest> requests(const ResearchContext& context, glm::uvec2 rows) const;
  void take(const ResearchContext& context, const std::vector<app::ViewPicture>& pictures);
  /// `end`: slice and column of a ray's end, 0 to 1 over the map, and its normalised depth; nothing: none is pointed
  /// at.
  void draw(ResearchContext& context, glm::uvec2 rows, const std::optional<glm::vec3>& end);

 private:
  struct Level {
    std::uint32_t width = 0;
    std::vector<WalkRow::Texel> texels;
  };
  WalkRow rowOf(std::uint32_t slice) const;
  void table(const Walk& walk) const;

  app::ViewPicture ranks_;
  std::vector<Level> levels_;
  bool across_ = false;  ///< positions run along x
};

}  // namespace tyndall::editor
