#pragma once

#include <string>
#include <vector>

#include "core/store/plan_file.hpp"

namespace morphe::report {

/// Which plans of a file are shown.
struct Selection {
  std::string pattern;  ///< of "<demonstration>/<000>", * and ? stand for any; "" = all
  bool failed = false;  ///< infeasible ones alone
  int worst = 0;        ///< this many that are worst by `by`; 0 = all
  std::string by;       ///< one of worst_by_names()
};

/// tips, grasp, clearance, tempo, upper_arm, humanlikeness, out_of_reach
std::vector<std::string> worst_by_names();

struct Selected {
  std::vector<std::size_t> plans;  ///< of the file, in its order
  std::string left_out;            ///< a sentence, "" if nothing is left out
};
/// Reads plans as far as the selection asks for their content. Of `worst`, plans without a value
/// come last; of equals the earlier one is worse.
Selected select_plans(const store::PlanReader& reader, const Selection& selection);

/// Whether a name matches a pattern of * and ?.
bool matches(std::string_view name, std::string_view pattern);

}  // namespace morphe::report
