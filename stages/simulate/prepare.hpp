#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/named.hpp"
#include "stages/simulate/rollout.hpp"

namespace morphe::simulate {

/// Why a plan cannot be simulated: it is infeasible; nothing in it is grasped; its numbers are
/// none, or its target's mesh has no inside; no two fingers can press against each other; the arm
/// cannot lift what it holds.
enum class Unfit { none, infeasible, no_grasp, broken, no_squeeze, no_lift };
constexpr std::array<std::string_view, 6> names_of(Unfit) {
  return {"none", "infeasible", "no_grasp", "broken", "no_squeeze", "no_lift"};
}

struct Prepared {
  PreparedPlan plan;
  Unfit unfit = Unfit::none;
  std::string detail;              ///< a sentence, "" if it is fit
  std::vector<std::string> notes;  ///< what was assumed, a sentence each
};

/// Robot and plan must outlive it.
Prepared prepare(const robot::Robot& robot, const Plan& plan, const SimulateOptions& options);

}  // namespace morphe::simulate
