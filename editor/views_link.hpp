// The link between pixels and rectified maps, both ways: which texel a pixel's ray ends in, and which light ray a texel
// is. Knows the maps by the roles of the plugin's debug views (TyViewRole) alone.
#pragma once

#include <optional>

#include <glm/glm.hpp>

#include "research_context.hpp"
#include "views_walk.hpp"

namespace tyndall::editor {

/// A place in the maps of rows, whatever their size.
struct RowPlace {
  glm::vec2 share{0};     ///< slice and column, 0 to 1 over the map
  float inclination = 0;  ///< rad
  float depth = 0;        ///< normalised
};
struct LightRay {
  glm::vec3 start{0}, end{0};  ///< world, m
  bool blocked = false;        ///< `end` is a blocker
};

class RowLink {
 public:
  bool open = false;  ///< its window

  /// Views that the link needs of a frame; none while nothing is linked or the technique has no rows.
  std::vector<app::ViewRequest> requests(const ResearchContext& context) const;
  /// New numbers; `shot` is what they are of.
  void take(const ResearchContext& context, const std::vector<app::ViewPicture>& pictures, const Shot& shot);
  bool stale(const ResearchContext& context) const { return !(shot_ == context.shot); }

  void hover(std::optional<glm::ivec2> pixel) { pixel_ = pixel; }  ///< of the picture, in this frame
  void pin(glm::vec2 share) { pinned_ = share; }                   ///< of the maps of rows
  /// Looks up what hovered pixel and pinned texel are.
  void update(ResearchContext& context);

  const std::optional<glm::ivec2>& pixel() const { return pixel_; }
  const std::optional<RowPlace>& place() const { return place_; }
  const std::optional<glm::vec2>& pinned() const { return pinned_; }
  /// Crosses and the ray's part of its row, on an image of the maps. `pointOf` maps shares to points.
  void drawMarks(ImDrawList& list, const std::function<ImVec2(glm::vec2)>& pointOf) const;
  /// The light rays of both, over the picture.
  void drawRays(const ResearchContext& context, ImDrawList& list, glm::vec2 low, glm::vec2 size) const;
  /// The window with the row's depths.
  void draw(ResearchContext& context);

 private:
  std::optional<LightRay> rayAt(glm::vec2 share) const;
  void drawProfile(float height) const;
  /// Slices and columns of the maps; 0 while they are not known.
  glm::uvec2 rows() const { return {depths_.width, depths_.height}; }

  app::ViewPicture places_, starts_, ends_, depths_;
  Shot shot_;
  std::optional<glm::ivec2> pixel_;
  std::optional<RowPlace> place_;
  std::optional<glm::vec2> pinned_;
  std::optional<LightRay> hoveredRay_, pinnedRay_;
  WalkView walk_;
};

}  // namespace tyndall::editor
