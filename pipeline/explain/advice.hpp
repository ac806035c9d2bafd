#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::explain {

/// What an advice does about a movement that is infeasible.
///   solves   asks the same of the robot by other means; whether that is enough, planning tells
///   accepts  asks for less: what is wrong stays as it is, and is allowed
///   assumes  what nobody recorded, and was therefore assumed, is assumed otherwise
///   changes  something that no key of the config stands for: the recording, the scene, the robot
enum class Effect { solves, accepts, assumes, changes };
constexpr std::array<std::string_view, 4> names_of(Effect) {
  return {"solves", "accepts", "assumes", "changes"};
}

struct Advice {
  Effect effect = Effect::changes;
  std::vector<std::string> settings;  ///< KEY=VALUE as `morphe run --set` takes them, all at once
  std::string sentence;               ///< why, with the case's numbers
};

/// What to try for an infeasible plan, from its own numbers; at least one. First what may solve it,
/// then what accepts it.
std::vector<Advice> advice_for(const robot::Robot& robot, const Plan& plan);

/// "may solve it: --set map.starts=48 (…)".
std::string text_of(const Advice& advice);

}  // namespace morphe::explain
