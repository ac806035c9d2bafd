#pragma once

#include <string>
#include <string_view>

namespace morphe::commands {

/// What --help shows below the options of a command ("robot setup"), a line each: commands that
/// work as they stand where Morphe's configs and datasets are. "" if there are none.
std::string examples_of(std::string_view command);

}  // namespace morphe::commands
