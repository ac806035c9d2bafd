#pragma once

#include <string>
#include <string_view>

namespace morphe::imports {

/// Returns the unit that a word denotes in any case, number and spelling ("Millimetres", "inch",
/// "[cm]"): m, dm, cm, mm, um, in or ft; "" for any other word.
std::string length_unit(std::string_view word);

/// Returns the unit of time that a word denotes in the same way: s, ms, us or ns; "" for others.
std::string time_unit(std::string_view word);

}  // namespace morphe::imports
