// The researcher's side of the editor: debug views as image viewers, the link between pixels and rectified maps,
// references, and the plot of error against time. The editor gives it each frame what the viewport shows; it does its
// work beside the window.
#pragma once

#include <memory>
#include <vector>

#include "plot_panel.hpp"
#include "truth_panel.hpp"
#include "views_link.hpp"
#include "views_window.hpp"

namespace tyndall::editor {

class Research {
 public:
  Research(app::Session& session, ImGuiRenderer& renderer, Laboratory::Options options)
      : session_(session), renderer_(renderer), options_(std::move(options)) {}

  /// What the viewport shows, and where on the screen (points).
  struct Viewport {
    scene::CameraView camera;
    std::uint32_t width = 0, height = 0;  ///< pixels
    glm::vec2 low{0}, size{0};
    bool hovered = false, moving = false;
  };
  /// Lines over the picture; into the viewport's own draw list.
  void drawOver(ImDrawList& list, Workspace& workspace, const Viewport& viewport);
  /// The bar in the viewport's corner and the windows that it opens.
  void draw(Workspace& workspace, const Viewport& viewport);

  bool busy() const { return laboratory_ && laboratory_->busy(); }
  std::uint32_t validationMessages() const { return laboratory_ ? laboratory_->validationMessages() : 0; }

 private:
  ResearchContext context(Workspace& workspace, const Viewport& viewport);
  Laboratory* laboratory(Workspace& workspace);
  void bar(ResearchContext& context, const Viewport& viewport);
  void viewMenu(ResearchContext& context);
  void updateViews(ResearchContext& context);

  app::Session& session_;
  ImGuiRenderer& renderer_;
  Laboratory::Options options_;
  bool laboratoryFailed_ = false;
  std::shared_ptr<const app::Level> level_;  ///< a copy of the session's, shared with background work
  std::uint32_t levelEdits_ = ~0u;
  std::string levelPath_;
  Shot lastShot_;
  double changedAt_ = 0;  ///< when the shot was another last, seconds of ImGui's clock

  std::vector<std::unique_ptr<ViewWindow>> windows_;
  int opened_ = 0;
  RowLink link_;
  TruthPanel truth_;
  PlotPanel plot_;
  JobPointer viewsJob_;
  Shot viewsShot_;           ///< that viewsJob_ is for, or was
  std::string viewsWanted_;  ///< which views, layers and mips it brings

  std::unique_ptr<Laboratory> laboratory_;  ///< last: its thread ends before what its jobs report to
};

}  // namespace tyndall::editor
