// A Markdown table that is printed and kept in <build>/figures/<name>.md as it grows.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace tyndall::figures {

class Report {
 public:
  explicit Report(const std::string& name);
  void line(const std::string& text);
  /// Heading and rule of a table.
  void head(const std::vector<std::string>& cells);
  void row(const std::vector<std::string>& cells);

 private:
  std::ofstream file_;
};

/// `value` with `digits` significant digits, never in exponent form.
std::string figure(double value, int digits = 3);

}  // namespace tyndall::figures
