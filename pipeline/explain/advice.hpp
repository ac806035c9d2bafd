#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::explain {

/// The effect of following an advice.
///   may_solve           the same goals may be met by other means; planning shows whether they are
///   relaxes_tolerance   the violation remains, but is permitted
///   changes_assumption  another assumption replaces that about something not recorded
///   changes_input       the user must change the recording, scene or robot, which no key does
enum class AdviceKind { may_solve, relaxes_tolerance, changes_assumption, changes_input };
constexpr std::array<std::string_view, 4> names_of(AdviceKind) {
  return {"may_solve", "relaxes_tolerance", "changes_assumption", "changes_input"};
}

/// An advice for an infeasible plan.
struct Advice {
  AdviceKind kind = AdviceKind::changes_input;
  std::vector<std::string> settings;  ///< KEY=VALUE for `morphe run --set`, to be set together
  std::string sentence;               ///< the reason, with the numbers of the plan
};

/// Returns at least one advice for an infeasible plan, those that may solve it first.
std::vector<Advice> advice_for(const robot::Robot& robot, const Plan& plan);

/// Returns the sentence, after "may solve it: --set map.starts=96 …: " if there are settings.
std::string text_of(const Advice& advice);

}  // namespace morphe::explain
