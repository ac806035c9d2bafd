#pragma once

#include <string>
#include <vector>

#include "core/store/plan_file.hpp"

namespace morphe::report {

/// A selection of the plans of a file.
struct Selection {
  std::string pattern;  ///< of "<demonstration>/<000>", with wildcards * and ?; "": all
  bool infeasible_only = false;
  int worst_count = 0;          ///< number of plans that are worst by `ranking_measure`; 0: all
  std::string ranking_measure;  ///< one of ranking_measure_names() if worst_count > 0
};

/// Returns the measures by which plans can be ranked: tip_error_max, tip_error_grasp, clearance,
/// duration_ratio, upper_arm_error, forearm_error, swivel_error, palm_error,
/// wrist_speed_correlation, humanlikeness and unreachable_share.
std::vector<std::string> ranking_measure_names();

/// The selected plans of a file.
struct SelectedPlans {
  std::vector<int> plans;  ///< indices in the file, in its order
  std::string left_out;    ///< sentence about omitted plans, or ""
};
/// Selects plans, which are read only if the selection depends on their content. Of plans with
/// equal values the earlier counts as worse; plans without a value count as best.
SelectedPlans select_plans(const store::PlanReader& reader, const Selection& selection);

/// Returns true if a name matches a pattern of * and ?.
bool matches_pattern(std::string_view name, std::string_view pattern);

/// Returns true if a plan "<demonstration>/<000>" or its demonstration matches a pattern.
bool plan_matches(std::string_view path, std::string_view pattern);

}  // namespace morphe::report
