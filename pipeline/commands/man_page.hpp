#pragma once

#include <string>

namespace CLI {
class App;
}

namespace morphe::commands {

/// Returns the manual page morphe(1) in the language of man(7): commands, arguments, options and
/// examples are those of `app`. The build writes it with `morphe --man`.
std::string man_page(const CLI::App& app);

}  // namespace morphe::commands
