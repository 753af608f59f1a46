// The parameter table as widgets: one row a parameter, in groups by the first part of the id.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/session.hpp"
#include "workspace.hpp"

namespace tyndall::editor {

class ParameterPanel {
 public:
  /// Draws into the current ImGui window. A refused value becomes the workspace's message.
  void draw(app::Session& session, Workspace& workspace);
  /// The search field gets the keyboard in the next frame.
  void search() { focusSearch_ = true; }
  /// A slider is held whose value is not in the table yet.
  bool pending() const { return pending_.has_value(); }

 private:
  bool found(const params::Parameter& parameter) const;
  void header(app::Catalogue& catalogue, Workspace& workspace);
  void row(app::Session& session, const params::Parameter& parameter, Workspace& workspace);
  void set(params::Table& table, const std::string& id, double value, Workspace& workspace);

  /// A slider being dragged whose parameter is structural: new images each frame would be slow, so the value is taken
  /// when the mouse lets go.
  struct Pending {
    std::string id;
    double value = 0;
  };
  std::optional<Pending> pending_;
  std::array<char, 64> sought_{};
  bool focusSearch_ = false, changedOnly_ = false;
};

}  // namespace tyndall::editor
