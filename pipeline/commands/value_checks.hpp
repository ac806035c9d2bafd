#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"

namespace morphe::commands {

// Checks of the values on a command line. Their messages follow "--option: ": "must be a whole
// number, not 'abc'".

/// Returns a check that a value is one of `names`; the message says what a renamed or misspelt one
/// is called.
CLI::Validator one_of(const std::vector<std::string>& names);

/// Returns a check that a value is a number within the bounds, which --help prints.
CLI::Validator within(const KeyBounds& bounds);

/// Lets all options of a command and its subcommands refuse values that they would ignore or that
/// CLI11 would refuse in its own words: an empty value, a value of a flag, and one that is not a
/// finite number (or not a whole one) where the type of the option is a number.
void check_values(CLI::App& app);

}  // namespace morphe::commands
