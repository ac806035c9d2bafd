#pragma once

#include <map>
#include <string>

#include "stages/simulate/ensemble.hpp"

namespace morphe::simulate {

/// {cause: how many}.
using FailureCounts = std::map<std::string, int>;

/// How often the newtons told hold from fall, of loads that came.
struct Foretold {
  std::size_t right = 0, all = 0;
  void add(const Rollout& one, const Holding& load) {
    if (!was_loaded(load.failure)) return;
    ++all;
    right += one.foretold(load) == load.held() ? 1U : 0U;
  }
};

/// What a plan's rollouts come to. NaN: there are none of that kind.
struct Figures {
  std::size_t held = 0, directions_held = 0, directions = 0;
  double sag_m = kNotSeen, slip_m = kNotSeen, creep_m = kNotSeen;  ///< medians of those that held
  double arm_error = kNotSeen, hand_error = kNotSeen, torque_share = kNotSeen;  ///< largest
  double contact_s = kNotSeen;  ///< median of the first touch less the planned one
  double needed_N = kNotSeen, given_N = kNotSeen;  ///< medians, as it is lifted
  Foretold foretold;                               ///< of lifts
  FailureCounts failures, direction_failures;
};
Figures figures_of(const PlanResult& result);

}  // namespace morphe::simulate
