// HTML and SVG that is well-formed XML by construction: every text is escaped, every element is closed.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::bench::report {

/// Text for element content and for attribute values in double quotes. What XML 1.0 cannot hold becomes U+FFFD.
std::string escape(std::string_view text);

/// A coordinate in user units, to 1/100.
std::string coordinate(double value);

struct Attribute {
  Attribute(const char* n, std::string v) : name(n), value(std::move(v)) {}
  Attribute(const char* n, const char* v) : name(n), value(v) {}
  Attribute(const char* n, double v) : name(n), value(coordinate(v)) {}
  const char* name;
  std::string value;  ///< not escaped yet
};
using Attributes = std::initializer_list<Attribute>;

class Markup {
 public:
  Markup& open(const char* element, Attributes attributes = {});
  Markup& close();
  /// An element without content ("<br/>"): for SVG shapes and HTML's void elements only.
  Markup& leaf(const char* element, Attributes attributes = {});
  Markup& text(std::string_view text);
  /// open, text, close.
  Markup& element(const char* element, std::string_view text, Attributes attributes = {});
  /// Markup that was made here before.
  Markup& raw(std::string_view markup);
  /// Everything; all elements must be closed.
  std::string take();

 private:
  void start(const char* element, Attributes attributes);
  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace tyndall::bench::report
