#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace tyndall::figures {

Report::Report(const std::string& name) {
  std::filesystem::create_directories(TYNDALL_FIGURES_DIR);
  file_.open(std::filesystem::path(TYNDALL_FIGURES_DIR) / (name + ".md"));
}

void Report::line(const std::string& text) {
  std::printf("%s\n", text.c_str());
  std::fflush(stdout);
  file_ << text << std::endl;
}

void Report::row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  line(text);
}

void Report::head(const std::vector<std::string>& cells) {
  row(cells);
  row(std::vector<std::string>(cells.size(), "---"));
}

std::string figure(double value, int digits) {
  const int before = value != 0 ? static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1 : 1;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(digits - before, 0, 6), value);
  return text;
}

}  // namespace tyndall::figures
