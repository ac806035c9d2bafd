#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stages/simulate/ensemble.hpp"

namespace morphe::simulate {

/// A plan's file (docs/formats.md): format "morphe-simulation". Reading gives every number back.
std::string result_json(const PlanResult& result, const SimulateOptions& options,
                        const std::string& key);
/// None unless the file is there, whole and of that key.
std::optional<PlanResult> read_result(const std::filesystem::path& file, const std::string& key);

/// A plan's file, for those who show it.
struct StoredResult {
  PlanResult result;
  std::string engine;
};
/// InputError: it is no such file.
StoredResult stored_result(const std::filesystem::path& file);

/// simulation.csv: a line a rollout, below this head.
std::string csv_head();
std::string csv_rows(const PlanResult& result);

}  // namespace morphe::simulate
