#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stages/simulate/ensemble.hpp"

namespace morphe::simulate {

/// Returns the content of a result file (docs/formats.md), which restores every number exactly.
std::string result_json(const PlanResult& result, const SimulateOptions& options,
                        const std::string& key);
/// Reads a result file; nullopt unless it exists, is complete and has that key (result_key()).
std::optional<PlanResult> read_result(const std::filesystem::path& file, const std::string& key);

/// The content of a plan's result file, for display.
struct StoredResult {
  PlanResult result;
  std::string engine;
};
/// Reads a result file for display. Throws InputError if it is not a valid result file.
StoredResult load_result(const std::filesystem::path& file);

/// Returns the head line of simulation.csv.
std::string csv_header();
/// Returns the rows of a plan in simulation.csv: one line per rollout, or one for a skipped plan.
std::string csv_rows(const PlanResult& result);

}  // namespace morphe::simulate
