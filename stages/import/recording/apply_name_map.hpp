#pragma once

#include <map>
#include <string>
#include <vector>

namespace morphe::imports {

/// Replaces recorded names by those used here. Throws InputError "FILE: names: …" if a name of the
/// map was not recorded, or two recorded names become one.
void apply_name_map(const std::string& file, const std::map<std::string, std::string>& renamed,
                    std::vector<std::string>& names);

}  // namespace morphe::imports
