#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe {

/// Where the robot stands before and after a plan (config section `approach`).
struct ApproachOptions {
  struct Joint {
    std::string joint;
    double value = 0;  ///< [rad]
  };
  std::vector<Joint> home;   ///< joints that are not named: 0, or their nearest limit
  double limit_share = 0.5;  ///< of velocity, acceleration and jerk on the way
  bool back = true;          ///< a retreat too
};
template <class Fields>
void fields(Fields& f, ApproachOptions::Joint& o) {
  f.required("joint", o.joint);
  f.required("value", o.value);
}
template <class Fields>
void fields(Fields& f, ApproachOptions& o) {
  f("home", o.home);
  f("limit_share", o.limit_share);
  f("back", o.back);
}
std::string check(const ApproachOptions& options);

/// All joints at home. The joints that the options name are the robot's.
JointVector home_posture(const RobotTable& robot, const ApproachOptions& options);

struct Planner;

/// Plans, times and certifies the approach of an executable plan from home to its first sample, and
/// the retreat from its last one, in the plan's scene as it stands at these times. The reason is
/// `no_approach` or `no_retreat` if there is no such way. A retreat lets go: what the hand touches
/// may be touched on the way; where no other is found it goes back the way it came. A target in the
/// hand at the end would have to be carried home: there is no retreat then.
struct ApproachResult {
  std::string reason, detail;  ///< "" = done
};
ApproachResult add_approach(const Planner& planner, const ApproachOptions& options,
                            std::uint64_t seed, Plan& plan);

}  // namespace morphe
