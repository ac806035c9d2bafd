#pragma once

#include <string>
#include <string_view>

namespace morphe::commands {

/// Returns the examples that --help prints below the options of a command ("robot setup"), one per
/// line. The commands can be run unchanged in a folder with Morphe's configs and datasets. Returns
/// "" if there are no examples.
std::string examples_of(std::string_view command);

}  // namespace morphe::commands
