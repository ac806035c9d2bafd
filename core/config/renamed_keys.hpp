#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphe::config {

/// The candidate that a key, or a value of an enumeration, of this old name is called by today; ""
/// if the name is none of the old ones, or no candidate is its new one.
std::string renamed_key(std::string_view old_name, const std::vector<std::string>& candidates);

/// The other way round: which of the words is an old name of `name`; "" if none is.
std::string former_key(std::string_view name, const std::vector<std::string>& words);

/// "; it is now called 'x'", or "".
std::string renaming_hint(std::string_view old_name, const std::vector<std::string>& candidates);

}  // namespace morphe::config
