#pragma once

#include <string>
#include <vector>

namespace morphe::imports {

/// Appends _2, _3, … to each name that stands before it in the list, such that all names differ,
/// and adds a note about it.
void number_repeated_names(std::vector<std::string>& names, std::vector<std::string>& notes);

}  // namespace morphe::imports
