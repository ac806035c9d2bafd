#pragma once

#include <map>
#include <string>
#include <vector>

namespace morphe::setup {

/// A section of a generated file, with a unique name.
struct Section {
  std::string name, text;
};

/// Joins the sections, each below a line "#: NAME HASH" with the hash of its text.
std::string join_sections(const std::vector<Section>& sections);

/// Returns the texts of the sections of a file that a person has changed, by their names.
std::map<std::string, std::string> edited_sections(const std::string& text);

/// Joins the sections, but replaces each by the section of its name in the file `before` if a
/// person has changed that: its text does not match its hash. Appends the names of those to `kept`.
std::string merge_sections(const std::vector<Section>& sections, const std::string& before,
                           std::vector<std::string>& kept);

}  // namespace morphe::setup
