#pragma once

#include "pipeline/commands/plan_row.hpp"

namespace CLI {
class App;
}

namespace morphe::commands {

/// Adds --sort KEY and --only WHAT.
void add_row_options(CLI::App& app, RowSelection& choice);

}  // namespace morphe::commands
