// One debug view as an image viewer: its numbers, zoomed, stretched, read out.
#pragma once

#include <string>

#include "research_context.hpp"
#include "views_canvas.hpp"
#include "views_colour.hpp"
#include "views_link.hpp"

namespace tyndall::editor {

class ViewWindow {
 public:
  ViewWindow(std::string view, int number) : view_(std::move(view)), number_(number) {}

  const std::string& view() const { return view_; }
  app::ViewRequest request() const { return {view_, layer_, mip_}; }
  void take(app::ViewPicture picture, const Shot& shot);

  /// False once it was closed. `job`: the one that brings new numbers.
  bool draw(ResearchContext& context, RowLink& link, const JobPointer& job);

 private:
  void toolbar(Workspace& workspace);
  void partChoice(Workspace& workspace);
  void rangeFields(Workspace& workspace);
  void readOut(ResearchContext& context, const std::optional<glm::ivec2>& texel, bool linked);
  void showOwnRange();

  std::string view_;
  int number_;  ///< tells windows of one view apart
  app::ViewPicture picture_;
  Shot shot_;  ///< that `picture_` is of
  std::optional<std::uint32_t> layer_, mip_;
  Stretch stretch_;
  ViewCanvas canvas_;
  ViewTexture texture_;
  bool mapped_ = false;  ///< the texture shows `picture_` by `stretch_`
};

}  // namespace tyndall::editor
