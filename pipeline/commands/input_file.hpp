#pragma once

#include <CLI/CLI.hpp>

namespace morphe::commands {

/// Returns a validator for an option that names a file to read: a file that does not exist at its
/// path is searched among the shipped files.
CLI::Validator input_file();

}  // namespace morphe::commands
