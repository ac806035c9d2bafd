#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <string>
#include <vector>

namespace morphe::files {

using XmlElement = tinyxml2::XMLElement;

/// A URDF or SRDF as text, for what is wrong with it and where: "FILE:LINE: KEY: message".
struct XmlText {
  std::filesystem::path file;
  tinyxml2::XMLDocument document;

  /// Throws InputError if the file cannot be read, is no XML, or has another root element.
  XmlText(const std::filesystem::path& path, const char* root);

  const XmlElement& root() const { return *document.RootElement(); }
  [[noreturn]] void fail(const XmlElement& element, const std::string& key,
                         const std::string& message) const;
  /// The element's attribute; fails with the element's line if it is missing or empty.
  std::string attribute(const XmlElement& element, const char* name) const;
};

std::vector<const XmlElement*> children(const XmlElement& parent, const char* tag);

}  // namespace morphe::files
