#pragma once

#include <string>
#include <vector>

namespace morphe::setup {

/// A section of a generated file, with a unique name.
struct Section {
  /// The name and the content.
  std::string name, text;
};

/// Joins the sections, each below a line "#: NAME HASH" with the hash of its text.
std::string join_sections(const std::vector<Section>& sections);

/// Joins the sections and keeps those that a person has changed in `before`: a section whose text
/// no longer matches its hash remains unchanged, and so does one that has no such line. `kept`
/// receives their names.
std::string merge_sections(const std::vector<Section>& sections, const std::string& before,
                           std::vector<std::string>& kept);

}  // namespace morphe::setup
