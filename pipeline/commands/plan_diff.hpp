#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/plan_row.hpp"
#include "pipeline/run/diff.hpp"

namespace morphe::commands {

/// A plan of two files; a row is absent if its file does not contain the plan.
struct PlanPair {
  /// The name of the plan.
  std::string name;
  /// The rows of the two files.
  std::optional<PlanRow> first, second;

  /// Returns true if both files contain the plan.
  bool in_both() const { return first && second; }
  /// Returns true if both files contain the plan with different status.
  bool status_changed() const;
  /// Returns second - first of a figure in SI units, NaN if it does not apply in one of the files.
  double change(std::size_t figure) const;
};

/// The change of a figure over the plans that have it in both files.
struct FigureChange {
  /// The number of these plans.
  std::size_t plans = 0;
  /// The medians in the two files.
  double median_first = kUnknown, median_second = kUnknown;
  /// Signed change that is largest in magnitude.
  double max_change = 0;
  /// Plan with this change, "" if there is no change.
  std::string plan;
};

/// The differences of two plans.h5 files.
struct PlanDiff {
  /// The paths of the files.
  std::filesystem::path first, second;
  /// In the order of the first file, then those that only the second contains.
  std::vector<PlanPair> pairs;
  /// The changes of all figures.
  std::array<FigureChange, kPlanFigureCount> figures;
  /// Changes of the config, such as "map.starts 24 -> 32".
  std::vector<std::string> config_changes;
  /// Other differences of the files, such as "another dataset".
  std::vector<std::string> file_changes;
  /// Bitwise differences.
  run::DiffReport dataset_differences;

  /// Returns true if the files are equal.
  bool equal() const { return dataset_differences.differences.empty(); }
};

/// Compares two plans.h5 files.
PlanDiff compare_plans(const std::filesystem::path& first, const std::filesystem::path& second);

/// Selects the pairs for --only and --sort: a pair is selected if one of its rows is; pairs with
/// the largest change come first.
std::vector<PlanPair> select_pairs(const PlanDiff& diff, const RowSelection& choice);

/// Returns the summary, then a row for each plan of `pairs` that changed; with `all`, every dataset
/// as well.
std::string diff_text(const PlanDiff& diff, const std::vector<PlanPair>& pairs, bool all,
                      std::size_t width);
/// Returns the differences as JSON, as docs/formats.md defines it.
std::string diff_json(const PlanDiff& diff);

}  // namespace morphe::commands
