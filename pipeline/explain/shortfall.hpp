#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::explain {

/// A tip that is farther from its goal than its phase allows, where it is farthest beyond that.
struct Miss {
  std::string tip;
  double time_s = 0;  ///< demonstration time
  double error_m = 0, allowed_m = 0;
  bool grasping = false;
};

/// A pair that comes nearer than it may.
struct Contact {
  std::string first, second;
  double begin_s = 0, end_s = 0;  ///< demonstration time
  double missing_m = 0;           ///< of what is required
  double required_m = 0;          ///< the margin, or minus the depth that is allowed
  std::string_view key;           ///< of the config, which asks for that
  bool with_object = false;
};

/// What is wrong with the path that an infeasible plan ended with.
struct Shortfall {
  std::optional<Miss> in_grasp, elsewhere;  ///< the worst of each
  std::vector<Contact> contacts;            ///< the worst first
  std::vector<Finding> jumps, limits;       ///< likewise
  bool empty() const;
};

/// From the path and what repair has left of its findings (of the mapped path, in files of earlier
/// versions).
Shortfall shortfall_of(const robot::Robot& robot, const Plan& plan);

}  // namespace morphe::explain
