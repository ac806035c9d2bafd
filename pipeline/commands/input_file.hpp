#pragma once

#include <CLI/CLI.hpp>

namespace morphe::commands {

/// For an option that names a file to read: one that is not there may be a shipped one.
CLI::Validator input_file();

}  // namespace morphe::commands
