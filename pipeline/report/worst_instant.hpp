#pragma once

#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// Finds the instant of an infeasible plan at which the condition named by its reason is violated
/// most: the least slack, the tip farthest beyond its tolerance, or the deepest finding. Returns an
/// empty value if no motion was planned or if the reason does not refer to an instant.
std::optional<WorstInstant> worst_instant(const robot::Robot& robot, const Plan& plan,
                                          const std::vector<DisplayMotion>& motions);

}  // namespace morphe::report
