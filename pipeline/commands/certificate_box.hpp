#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/assumption_text.hpp"
#include "pipeline/commands/plan_row.hpp"

namespace morphe::commands {

/// The properties for which the certificates of several plans hold, and their assumptions.
struct CertificateBox {
  AssumptionTally tally;                                 ///< over the plans with a trajectory
  int plans = 0;                                         ///< with a trajectory
  std::array<KindClearance, kClearanceKindCount> least;  ///< of all plans
  std::array<std::string, kClearanceKindCount> plan_of_least;

  /// Adds a plan. One without a trajectory is ignored.
  void add(const PlanRow& row);
  /// Returns the box with the assumptions of the file; "" without a plan.
  std::string text(const std::vector<Assumption>& of_file, std::size_t width) const;
};

}  // namespace morphe::commands
