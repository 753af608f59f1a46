// Plain text tables for stdout.
#include <algorithm>
#include <cstdio>

#include "app/median.hpp"
#include "stats.hpp"

namespace tyndall::app {
namespace {

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%10.3f", value);
  return text;
}

}  // namespace

std::string statsTable(const RenderOptions& options, Session& session, const RenderRun& run) {
  std::size_t nameWidth = 12, ownerWidth = 8;
  for (const render::PassTime& pass : run.passes) {
    nameWidth = std::max(nameWidth, pass.name.size());
    ownerWidth = std::max(ownerWidth, pass.owner.size());
  }
  std::string text = "device     " + session.device().info().name + "\n";
  text += "level      " + options.level + "\n";
  text += "size       " + std::to_string(options.size.first) + "x" + std::to_string(options.size.second) + "\n";
  text += "technique  " + session.catalogue().techniqueName() + "\n\n";
  text += padded("pass", nameWidth) + "  " + padded("owner", ownerWidth) + "      gpu ms\n";
  double owned = 0;
  for (const render::PassTime& pass : run.passes) {
    text += padded(pass.name, nameWidth) + "  " + padded(pass.owner, ownerWidth) + "  " +
            milliseconds(pass.milliseconds) + "\n";
    if (pass.owner == session.catalogue().effectPlugin().id()) owned += pass.milliseconds;
  }
  text += padded("of these", nameWidth) + "  " + padded(session.catalogue().effectPlugin().id(), ownerWidth) + "  " +
          milliseconds(owned) + "\n";
  text += padded("total", nameWidth) + "  " + padded("", ownerWidth) + "  " + milliseconds(totalMs(run.passes)) + "\n";
  return text;
}

}  // namespace tyndall::app
