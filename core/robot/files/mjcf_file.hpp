#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/files/xml_text.hpp"

namespace morphe::robot {

/// An MJCF (the XML of MuJoCo) with all files that it includes.
class MjcfFile {
 public:
  /// Throws InputError if a file cannot be read, is not XML or is included twice, or if the main
  /// file does not begin with <mujoco>. Paths of included files are relative to the main file's
  /// folder or else to that of the file that includes them.
  explicit MjcfFile(const std::filesystem::path& file);

  const std::filesystem::path& path() const { return texts_.front()->file; }
  const files::XmlElement& root() const { return texts_.front()->root(); }
  /// Returns the child elements; in the place of an `include`, those of the included file's root.
  std::vector<const files::XmlElement*> elements(const files::XmlElement& parent) const;
  /// Returns the child elements with this tag.
  std::vector<const files::XmlElement*> elements(const files::XmlElement& parent,
                                                 const char* tag) const;
  /// Returns the sections of the root with this tag, of which an MJCF may have several.
  std::vector<const files::XmlElement*> sections(const char* tag) const {
    return elements(root(), tag);
  }
  /// Returns "FILE:LINE" of an element.
  std::string place(const files::XmlElement& element) const;
  /// Throws InputError with the file and line of an element.
  [[noreturn]] void fail(const files::XmlElement& element, const std::string& key,
                         const std::string& message) const;

 private:
  const files::XmlText& text_of(const files::XmlElement& element) const;
  void load_includes(const files::XmlElement& element);
  void load_include(const files::XmlElement& include);

  std::vector<std::unique_ptr<files::XmlText>> texts_;                     ///< the main file first
  std::map<const files::XmlElement*, const files::XmlElement*> included_;  ///< roots by `include`
};

}  // namespace morphe::robot
