#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/commands/plan_row.hpp"
#include "pipeline/run/diff.hpp"

namespace morphe::commands {

/// A plan of either file; without a row where that file does not hold it.
struct PlanPair {
  std::string name;
  std::optional<PlanRow> first, second;

  bool in_both() const { return first && second; }
  bool status_changed() const;
  /// Of a figure, SI: second - first; NaN where it does not apply in one of them.
  double change(std::size_t figure) const;
};

/// What became of a figure over the plans of both files that have it in both.
struct FigureChange {
  std::size_t plans = 0;
  double median_first = kNotSeen, median_second = kNotSeen;
  double largest = 0;  ///< signed change of the plan that moved most
  std::string plan;    ///< that plan, "" if none moved
};

struct PlanDiff {
  std::filesystem::path first, second;
  std::vector<PlanPair> pairs;  ///< in the order of the first file, then what is the second's alone
  std::array<FigureChange, kPlanFigures> figures;
  std::vector<std::string> config;  ///< "map.starts 24 -> 32"
  std::vector<std::string> file;    ///< what else of the files differs: "another dataset"
  run::DiffReport data;             ///< bit for bit

  bool equal() const { return data.differences.empty(); }
};

PlanDiff compare_plans(const std::filesystem::path& first, const std::filesystem::path& second);

/// Pairs that --only and --sort choose: a pair is shown if either of its rows is, the one that
/// moved most first.
std::vector<PlanPair> chosen_pairs(const PlanDiff& diff, const RowChoice& choice);

/// Summary, then a row for each plan of `pairs` that changed; with `all` every dataset, too.
std::string diff_text(const PlanDiff& diff, const std::vector<PlanPair>& pairs, bool all,
                      std::size_t width);
/// docs/formats.md says what.
std::string diff_json(const PlanDiff& diff);

}  // namespace morphe::commands
