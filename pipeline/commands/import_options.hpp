#pragma once

#include "stages/import/import.hpp"

namespace CLI {
class App;
}

namespace morphe::commands {

/// Adds the options that describe recordings to be read: --static, --format, --names, --axes,
/// --unit, --rate and --hand. `request` must outlive the parsing.
void add_import_options(CLI::App& app, imports::ImportRequest& request);

}  // namespace morphe::commands
