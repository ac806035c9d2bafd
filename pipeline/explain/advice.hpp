#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::explain {

/// The effect of an advice for an infeasible movement.
///   solves   achieves the same goals by other means; only planning shows if they suffice
///   accepts  relaxes requirements: the violation remains and is allowed
///   assumes  changes an assumption about something that was not recorded
///   changes  changes something without a key in the config: the recording, the scene, the robot
enum class AdviceKind { may_solve, relaxes_tolerance, changes_assumption, changes_input };
constexpr std::array<std::string_view, 4> names_of(AdviceKind) {
  return {"may_solve", "relaxes_tolerance", "changes_assumption", "changes_input"};
}

/// An advice for an infeasible plan.
struct Advice {
  AdviceKind kind = AdviceKind::changes_input;
  /// KEY=VALUE as accepted by `morphe run --set`, to be applied together
  std::vector<std::string> settings;
  std::string sentence;  ///< the reason, with the numbers of the plan
};

/// Returns the advice for an infeasible plan, derived from its own numbers; at least one. Advice
/// that may solve it comes first, then advice that accepts it.
std::vector<Advice> advice_for(const robot::Robot& robot, const Plan& plan);

/// Returns "may solve it: --set map.starts=48 (…)".
std::string text_of(const Advice& advice);

}  // namespace morphe::explain
