#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphe::config {

/// Returns the one of `candidates` that the option ("--out"), key or enumeration value `old_name`
/// is called today, or "" if it was not renamed to one of them.
std::string current_name(std::string_view old_name, const std::vector<std::string>& candidates);

/// Returns the one of `candidates` that is an old name of `name`, or "".
std::string former_name(std::string_view name, const std::vector<std::string>& candidates);

/// Returns "; it is now called 'x'" with x from current_name(), or "" if that is empty.
std::string renaming_hint(std::string_view old_name, const std::vector<std::string>& candidates);

}  // namespace morphe::config
