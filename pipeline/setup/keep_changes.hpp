#pragma once

#include <string>
#include <vector>

namespace morphe::setup {

/// A part of a generated file, with a name that it has once.
struct Section {
  std::string name, text;
};

/// The sections one after the other, each below a line "#: NAME HASH" with the hash of its text.
std::string joined(const std::vector<Section>& sections);

/// The same with what a person changed in `before` kept: a section whose text is no longer that of
/// its hash stays as it is there, and so does one that has no such line. `kept` names them.
std::string joined_over(const std::vector<Section>& sections, const std::string& before,
                        std::vector<std::string>& kept);

}  // namespace morphe::setup
