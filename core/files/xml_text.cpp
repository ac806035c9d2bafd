#include "core/files/xml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "core/files/printable.hpp"
#include "core/files/text_encoding.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::files {
namespace {

std::string error_text(const tinyxml2::XMLDocument& document) {
  constexpr std::pair<tinyxml2::XMLError, const char*> kTexts[] = {
      {tinyxml2::XML_ERROR_EMPTY_DOCUMENT, "the file is empty"},
      {tinyxml2::XML_ERROR_PARSING, "an element is not closed"},
      {tinyxml2::XML_ERROR_MISMATCHED_ELEMENT, "an element is closed by the end tag of another"},
      {tinyxml2::XML_ERROR_PARSING_ELEMENT, "an element cannot be read"},
      {tinyxml2::XML_ERROR_PARSING_ATTRIBUTE, "an attribute cannot be read"},
      {tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED, "elements are nested too deeply"}};
  for (const auto& [error, text] : kTexts)
    if (error == document.ErrorID()) return text;
  return document.ErrorName();
}

}  // namespace

XmlText::XmlText(const std::filesystem::path& path, const GivenFiles* given)
    : file(located(path, given)) {
  std::string text = read_bytes(file, given);
  if (const auto order = utf16_order(text)) text = utf8_from_utf16(text, *order);
  document.Parse(text.c_str());
  if (document.Error()) {
    throw InputError(fmt::format("{}:{}: not valid XML: {}", path.string(),
                                 std::max(1, document.ErrorLineNum()), error_text(document)));
  }
  if (!document.RootElement())
    throw InputError(fmt::format("{}:1: not valid XML: has no element", path.string()));
}

XmlText::XmlText(const std::filesystem::path& path, const char* root, const GivenFiles* given)
    : XmlText(path, given) {
  const XmlElement* top = document.RootElement();
  if (std::strcmp(top->Value(), root) != 0) {
    throw InputError(
        fmt::format("{}:{}: must begin with <{}>", path.string(), top->GetLineNum(), root));
  }
}

void XmlText::fail(const XmlElement& element, const std::string& key,
                   const std::string& message) const {
  throw InputError(fmt::format("{}:{}: {}: {}", file.string(), element.GetLineNum(),
                               make_printable(key), make_printable(message)));
}

std::string XmlText::attribute(const XmlElement& element, const char* name) const {
  const char* value = element.Attribute(name);
  if (!value || !*value) fail(element, fmt::format("{}.{}", element.Value(), name), "is missing");
  return value;
}

std::vector<const XmlElement*> children(const XmlElement& parent, const char* tag) {
  std::vector<const XmlElement*> found;
  for (const XmlElement* child = parent.FirstChildElement(tag); child;
       child = child->NextSiblingElement(tag))
    found.push_back(child);
  return found;
}

}  // namespace morphe::files
