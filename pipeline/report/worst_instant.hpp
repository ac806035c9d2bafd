#pragma once

#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// The instant of an infeasible plan that is farthest from what its reason is about: the least
/// slack, the tip farthest beyond its tolerance, the deepest finding. None: nothing was planned, or
/// the reason has no instant.
std::optional<WorstInstant> worst_instant(const robot::Robot& robot, const Plan& plan,
                                          const std::vector<ShownMotion>& motions);

}  // namespace morphe::report
