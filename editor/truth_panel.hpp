// The window that compares the present settings with a reference: split, flicker, error map, figures.
#pragma once

#include "truth_reference.hpp"
#include "views_canvas.hpp"

namespace tyndall::editor {

class TruthPanel {
 public:
  bool open = false;
  Reference reference;

  void draw(ResearchContext& context);

 private:
  enum class Show { kSplit, kFlicker, kPicture, kReference, kError };
  void controls(ResearchContext& context);
  void figures(ResearchContext& context);
  void showChoice(ResearchContext& context);
  void picture(ResearchContext& context);
  void map(ResearchContext& context);
  void divider(const ViewCanvas::Seen& seen, ResearchContext& context, glm::vec2 image);
  void scaleBar(const ViewCanvas::Seen& seen) const;

  Show show_ = Show::kSplit;
  float divider_ = 0.5f;    ///< share of the picture that shows the present settings
  float mostError_ = 0.1f;  ///< relative to the reference's mean: the ends of the map's colours
  ViewCanvas canvas_;
  ViewTexture picture_, reference_, error_;
  std::uint32_t mapped_ = ~0u;  ///< version of the pictures in the textures
  float mappedExposure_ = 0, mappedError_ = 0;
  bool dividerHeld_ = false;
};

}  // namespace tyndall::editor
