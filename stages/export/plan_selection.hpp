#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/store/plan_file.hpp"
#include "stages/export/table/dataset_card.hpp"
#include "stages/export/table/split.hpp"

namespace morphe::exports {

/// A plan that is exported.
struct ChosenPlan {
  std::size_t index = 0;  ///< in the file
  std::string_view side;  ///< train or valid, "" without a split
};

/// The plans that are exported, in the order of the file.
struct PlanSelection {
  std::vector<ChosenPlan> plans;
  PlanCounts counts;
};

/// Returns the plans that satisfy a condition (Condition; "": all), with their sides of the split.
/// Throws InputError if the condition is invalid, or if no plan of the file satisfies it.
PlanSelection select_plans(const store::PlanReader& reader, const std::string& where,
                           const SplitOptions& split);

}  // namespace morphe::exports
