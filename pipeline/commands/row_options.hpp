#pragma once

#include "pipeline/commands/plan_row.hpp"

namespace CLI {
class App;
}

namespace morphe::commands {

/// --sort KEY and --only WHAT.
void add_row_options(CLI::App& app, RowChoice& choice);

}  // namespace morphe::commands
