#include "document.hpp"

#include <expat.h>
#include <gtest/gtest.h>

namespace tyndall::bench::test {
namespace {

struct Builder {
  std::unique_ptr<Element> root;
  Element* open = nullptr;
};

void XMLCALL start(void* data, const char* name, const char** attributes) {
  auto& b = *static_cast<Builder*>(data);
  auto element = std::make_unique<Element>();
  element->name = name;
  element->parent = b.open;
  for (; *attributes; attributes += 2) element->attributes[attributes[0]] = attributes[1];
  Element* raw = element.get();
  if (b.open)
    b.open->children.push_back(std::move(element));
  else
    b.root = std::move(element);
  b.open = raw;
}

void XMLCALL end(void* data, const char*) {
  auto& b = *static_cast<Builder*>(data);
  if (b.open->parent) b.open->parent->text += b.open->text;
  b.open = b.open->parent;
}

void XMLCALL characters(void* data, const char* text, int length) {
  static_cast<Builder*>(data)->open->text.append(text, static_cast<std::size_t>(length));
}

}  // namespace

std::string Element::attribute(const std::string& key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? "" : found->second;
}

bool Element::hasClass(const std::string& one) const {
  return (" " + attribute("class") + " ").find(" " + one + " ") != std::string::npos;
}

std::vector<const Element*> Element::all(const std::string& element, const std::string& className) const {
  std::vector<const Element*> found;
  for (const auto& child : children) {
    if (child->name == element && (className.empty() || child->hasClass(className))) found.push_back(child.get());
    for (const Element* e : child->all(element, className)) found.push_back(e);
  }
  return found;
}

std::unique_ptr<Element> parse(const std::string& xml, std::string& error) {
  Builder builder;
  XML_Parser parser = XML_ParserCreate("UTF-8");
  XML_SetUserData(parser, &builder);
  XML_SetElementHandler(parser, start, end);
  XML_SetCharacterDataHandler(parser, characters);
  if (XML_Parse(parser, xml.data(), static_cast<int>(xml.size()), 1) != XML_STATUS_OK) {
    const auto at = static_cast<std::size_t>(XML_GetCurrentByteIndex(parser));
    error = std::string(XML_ErrorString(XML_GetErrorCode(parser))) + " near: " + xml.substr(at > 60 ? at - 60 : 0, 120);
    builder.root = nullptr;
  }
  XML_ParserFree(parser);
  return std::move(builder.root);
}

std::unique_ptr<Element> page(const std::string& html) {
  std::string error;
  auto root = parse(html, error);
  EXPECT_TRUE(root) << error;
  return root ? std::move(root) : std::make_unique<Element>();
}

}  // namespace tyndall::bench::test
