// The parameter table as widgets: one row a parameter, in groups by the first part of the id.
#pragma once

#include <optional>
#include <string>

#include "app/catalogue.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class ParameterPanel {
 public:
  /// Draws into the current ImGui window. A refused value becomes the workspace's message.
  void draw(app::Catalogue& catalogue, Workspace& workspace);

 private:
  void row(app::Catalogue& catalogue, const params::Parameter& parameter, Workspace& workspace);
  void set(params::Table& table, const std::string& id, double value, Workspace& workspace);

  /// A slider being dragged whose parameter is structural: new images each frame would be slow, so the value is taken when
  /// the mouse lets go.
  struct Pending {
    std::string id;
    double value = 0;
  };
  std::optional<Pending> pending_;
};

}  // namespace tyndall::editor
