#include "pipeline/files/xml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include "pipeline/motion/input_error.hpp"

namespace morphe::files {

XmlText::XmlText(const std::filesystem::path& path, const char* root) : file(path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream || std::filesystem::is_directory(path)) {
    throw InputError(fmt::format("{}: cannot be read", path.string()));
  }
  document.Parse(text.str().c_str());
  if (document.Error()) {
    throw InputError(fmt::format("{}:{}: not valid XML: {}", path.string(),
                                 std::max(1, document.ErrorRow()), document.ErrorDesc()));
  }
  const TiXmlElement* top = document.RootElement();
  if (!top || std::strcmp(top->Value(), root) != 0) {
    throw InputError(
        fmt::format("{}:{}: must begin with <{}>", path.string(), top ? top->Row() : 1, root));
  }
}

void XmlText::fail(const TiXmlElement& element, const std::string& key,
                   const std::string& message) const {
  throw InputError(fmt::format("{}:{}: {}: {}", file.string(), element.Row(), key, message));
}

std::string XmlText::attribute(const TiXmlElement& element, const char* name) const {
  const char* value = element.Attribute(name);
  if (!value || !*value) fail(element, fmt::format("{}.{}", element.Value(), name), "is missing");
  return value;
}

std::vector<const TiXmlElement*> children(const TiXmlElement& parent, const char* tag) {
  std::vector<const TiXmlElement*> found;
  for (const TiXmlElement* child = parent.FirstChildElement(tag); child;
       child = child->NextSiblingElement(tag)) {
    found.push_back(child);
  }
  return found;
}

}  // namespace morphe::files
