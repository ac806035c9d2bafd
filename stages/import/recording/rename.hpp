#pragma once

#include <map>
#include <string>
#include <vector>

namespace morphe::imports {

/// Replaces recorded names by ours. InputError "FILE: names: …" if a name of the map was not
/// recorded, or two recorded names become one.
void rename(const std::string& file, const std::map<std::string, std::string>& renamed,
            std::vector<std::string>& names);

}  // namespace morphe::imports
