#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/plan_row.hpp"
#include "pipeline/run/diff.hpp"

namespace morphe::commands {

/// A plan in one or both of two files; a row is absent if its file does not contain the plan.
struct PlanPair {
  std::string name;
  std::optional<PlanRow> first, second;

  bool in_both() const { return first && second; }
  /// Returns true if both files contain the plan with different status.
  bool status_changed() const;
  /// Returns second - first of a figure in SI units, NaN if one of the files does not have it.
  double change(int figure) const;
};

/// The change of a figure over the plans that have it in both files.
struct FigureChange {
  int plans = 0;  ///< number of these plans
  double median_first = kUnknown, median_second = kUnknown;
  double max_change = 0;  ///< signed change of the largest magnitude
  std::string plan;       ///< name of the plan with max_change, "" without change
};

/// The differences of two plans.h5 files.
struct PlanDiff {
  std::filesystem::path first, second;
  std::string first_not_verified, second_not_verified;  ///< why; "" for files that are verified
  std::vector<PlanPair> pairs;  ///< in the order of the first file, then those of the second alone
  std::array<FigureChange, kPlanFigureCount> figures;
  std::vector<std::string> config_changes;  ///< such as "map.starts 24 -> 32"
  std::vector<std::string> file_changes;    ///< other changes, such as "another dataset"
  run::DiffReport dataset_differences;      ///< as run::diff_files() returns them

  bool equal() const { return dataset_differences.differences.empty(); }
};

/// Compares two plans.h5 files; plans that `verify` rejects have no figures, unless `unverified`.
/// Throws InputError for a file that is not a plans.h5.
PlanDiff compare_plans(const std::filesystem::path& first, const std::filesystem::path& second,
                       bool unverified, int jobs);

/// Returns the pairs of which a row is selected, sorted by name or by |change|, the largest first.
std::vector<PlanPair> select_pairs(const PlanDiff& diff, const RowSelection& choice);

/// Returns a summary, a row for each plan of `pairs` that changed and, with `all`, a line for every
/// dataset that differs. Lines are limited to `width` (0: unlimited).
std::string diff_text(const PlanDiff& diff, const std::vector<PlanPair>& pairs, bool all,
                      std::size_t width);
/// Returns the differences as JSON, as docs/formats.md defines it.
std::string diff_json(const PlanDiff& diff);

}  // namespace morphe::commands
