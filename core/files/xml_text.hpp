#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/given_files.hpp"

namespace morphe::files {

/// An element of an XML document.
using XmlElement = tinyxml2::XMLElement;

/// An XML document, which reports errors with their location: "FILE:LINE: KEY: message". It may be
/// in UTF-8 or UTF-16.
struct XmlText {
  std::filesystem::path file;
  tinyxml2::XMLDocument document;

  /// Throws InputError if the file cannot be read or is not XML.
  explicit XmlText(const std::filesystem::path& path, const GivenFiles* given = nullptr);
  /// Throws InputError also if the file has another root element.
  XmlText(const std::filesystem::path& path, const char* root, const GivenFiles* given = nullptr);

  /// Returns the root element.
  const XmlElement& root() const { return *document.RootElement(); }
  /// Throws InputError with the line of an element.
  [[noreturn]] void fail(const XmlElement& element, const std::string& key,
                         const std::string& message) const;
  /// Returns an attribute; throws InputError with the element's line if it is missing or empty.
  std::string attribute(const XmlElement& element, const char* name) const;
};

/// Returns the child elements with this tag.
std::vector<const XmlElement*> children(const XmlElement& parent, const char* tag);

}  // namespace morphe::files
