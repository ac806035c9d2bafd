#pragma once

#include <map>
#include <string>
#include <vector>

namespace morphe::imports {

/// Replaces each recorded name that is a key of `renamed` by its value. Throws InputError "FILE:
/// names: …" if a key was not recorded, or if two of the resulting names are equal.
void apply_name_map(const std::string& file, const std::map<std::string, std::string>& renamed,
                    std::vector<std::string>& names);

}  // namespace morphe::imports
