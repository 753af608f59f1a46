// A page as a tree, parsed by expat.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tyndall::bench::test {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<std::unique_ptr<Element>> children;
  std::string text;  ///< of this element and all below, in order
  Element* parent = nullptr;

  std::string attribute(const std::string& key) const;
  bool hasClass(const std::string& one) const;
  /// All elements below with this name, and with this class unless it is empty.
  std::vector<const Element*> all(const std::string& element, const std::string& className = "") const;
};

/// The root element; null with `error` set when the text is not well-formed XML.
std::unique_ptr<Element> parse(const std::string& xml, std::string& error);
/// Fails the running test when the text is not well-formed; never null then either (an empty element).
std::unique_ptr<Element> page(const std::string& html);

}  // namespace tyndall::bench::test
