#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/commands/plan_row.hpp"
#include "pipeline/commands/value_checks.hpp"
#include "stages/import/import.hpp"

namespace morphe::commands {

// The options that several commands share. The variables that they set must outlive the parsing.

/// Returns a transformation that searches a file to be read also among the shipped files.
CLI::Validator input_file();
/// Adds an option with input_file().
template <class Value>
CLI::Option* add_input_option(CLI::App& app, const char* name, Value& value, const char* help) {
  return app.add_option(name, value, help)->transform(input_file())->type_name("FILE");
}

/// Throws InputError "FILE: cannot be read; did you mean …?" if a file or folder to be read does
/// not exist.
void expect_exists(const std::filesystem::path& named);

/// Adds --jobs N; 0 (the default) means one thread per core.
void add_jobs_option(CLI::App& app, int& jobs);
/// Returns the number of threads for a value of --jobs: for 0 one per core, or as many as can be
/// started. Throws InputError if a given number cannot be started.
int threads_of(int jobs);

/// Adds --unverified, which sets `unverified`; `effect` continues "Do not verify the plans: ".
void add_unverified_option(CLI::App& app, bool& unverified, const char* effect);

/// Adds --sort KEY and --only WHAT, which set `choice` (see check_selection()).
void add_row_options(CLI::App& app, RowSelection& choice);

/// Throws InputError "OPTION has no effect REASON" unless it has.
void expect_effect(bool has_effect, const std::string& option, const std::string& reason);
/// Throws InputError if options of add_row_options() were given with an output without a table.
void expect_printed_rows(const RowSelection& choice, bool json, bool quiet);

/// Throws InputError if the request has options of add_import_options(), which change nothing in
/// `file`, a demonstrations.h5.
void expect_no_import_options(const imports::ImportRequest& request,
                              const std::filesystem::path& file);
/// Adds the options that describe recordings to be read, such as --static-trial and --axes.
void add_import_options(CLI::App& app, imports::ImportRequest& request);

}  // namespace morphe::commands
