#pragma once

#include <string>
#include <vector>

#include "core/store/plan_file.hpp"

namespace morphe::report {

/// A selection of the plans of a file.
struct Selection {
  std::string pattern;  ///< pattern for "<demonstration>/<000>" with wildcards * and ?, "" for all
  bool infeasible_only = false;  ///< true to select only infeasible plans
  int worst_count = 0;           ///< number of plans that are worst by `ranking_measure`, 0 for all
  std::string ranking_measure;   ///< one of ranking_measure_names()
};

/// Returns tips, grasp, clearance, tempo, upper_arm, humanlikeness and out_of_reach.
std::vector<std::string> ranking_measure_names();

/// The selected plans of a file.
struct SelectedPlans {
  std::vector<std::size_t> plans;  ///< indices in the file, in its order
  std::string left_out;  ///< sentence about omitted plans, "" if there are no omitted plans
};
/// Selects plans, reading them only as far as the selection depends on their content. If only the
/// worst are selected, plans without a value come last, and of equal plans the earlier one counts
/// as worse.
SelectedPlans select_plans(const store::PlanReader& reader, const Selection& selection);

/// Returns true if a name matches a pattern of * and ?.
bool matches_pattern(std::string_view name, std::string_view pattern);

}  // namespace morphe::report
