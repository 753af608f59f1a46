#include "markup.hpp"

#include <charconv>
#include <cmath>

#include "base/assert.hpp"

namespace tyndall::bench::report {

std::string escape(std::string_view text) {
  static constexpr const char* kReplacement = "\xEF\xBF\xBD";
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto code = static_cast<unsigned char>(c);
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else if (code < 0x20 && c != '\t' && c != '\n')
      out += kReplacement;
    else if (code == 0x7F)
      out += kReplacement;
    // U+FFFE and U+FFFF: the only characters of valid UTF-8 (which JSON guarantees) besides control codes that XML
    // refuses.
    else if (text.substr(i, 3) == "\xEF\xBF\xBE" || text.substr(i, 3) == "\xEF\xBF\xBF") {
      out += kReplacement;
      i += 2;
    } else
      out += c;
  }
  return out;
}

std::string coordinate(double value) {
  TY_ASSERT(std::isfinite(value), "a coordinate is " + std::to_string(value));
  char buffer[400];
  const double rounded = std::round(value * 100) / 100;
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, rounded == 0 ? 0.0 : rounded, std::chars_format::fixed, 2);
  std::string text(buffer, end.ptr);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

void Markup::start(const char* element, Attributes attributes) {
  out_ += '<';
  out_ += element;
  for (const Attribute& a : attributes) {
    out_ += ' ';
    out_ += a.name;
    out_ += "=\"" + escape(a.value) + '"';
  }
}

Markup& Markup::open(const char* element, Attributes attributes) {
  start(element, attributes);
  out_ += '>';
  open_.emplace_back(element);
  return *this;
}

Markup& Markup::close() {
  TY_ASSERT(!open_.empty(), "no element is open after " + out_.substr(out_.size() > 80 ? out_.size() - 80 : 0));
  out_ += "</" + open_.back() + ">";
  open_.pop_back();
  return *this;
}

Markup& Markup::leaf(const char* element, Attributes attributes) {
  start(element, attributes);
  out_ += "/>";
  return *this;
}

Markup& Markup::text(std::string_view text) {
  out_ += escape(text);
  return *this;
}

Markup& Markup::element(const char* element, std::string_view content, Attributes attributes) {
  return open(element, attributes).text(content).close();
}

Markup& Markup::raw(std::string_view markup) {
  out_ += markup;
  return *this;
}

std::string Markup::take() {
  TY_ASSERT(open_.empty(), "<" + open_.back() + "> is still open");
  return std::move(out_);
}

}  // namespace tyndall::bench::report
