#pragma once

#include "stages/import/import.hpp"

namespace CLI {
class App;
}

namespace morphe::commands {

/// What the command line says about recordings that are read: --static, --format, --names, --axes,
/// --unit, --rate and --hand. `request` must outlive the parsing.
void add_import_options(CLI::App& app, imports::ImportRequest& request);

}  // namespace morphe::commands
