#pragma once

#include <vector>

#include "core/motion/robot_table.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_runs.hpp"

namespace morphe::verify {

/// What one pair of bodies may do. `other` is a capsule, or an object of the scene if `object`.
struct ContactPair {
  int capsule = 0, other = 0;
  bool object = false;
  bool may_touch = false;  ///< touching finger or palm against the target
  bool pad = false;        ///< the capsule is that of a pad
  double radii = 0;        ///< taken off the distance of the axes [m]
  JointVector lever;       ///< [n] relative travel per radian [m/rad]
  std::string subject;     ///< "capsule/capsule"
};

/// When the target may be touched: from the first preshape (grasp, if there is none) to the end of
/// the last of grasp, hold and transport [demonstration time, s]; empty if those are missing.
struct TouchWindow {
  double begin_s = 1, end_s = 0;
  bool contains(double from_s, double to_s) const { return from_s >= begin_s && to_s <= end_s; }
};
TouchWindow touch_window(const std::vector<Phase>& phases);

/// All pairs of capsules but the allowed ones and those that nothing moves apart (one frame, or
/// both at the base), then each capsule against each object that can_judge().
std::vector<ContactPair> contact_pairs(const RobotTable& robot, const Plan& plan);

/// Notes `self` and `object` wherever a pair is closer than the plan's margin (or, where it may
/// touch, deeper than its contact depth; a capsule that is no pad: than its link depth, if it has
/// one), at the samples and all along between them, and `clearance` where the one that is stored
/// for a sample is not its own, to 1e-4 m. Returns the least distance along the whole curve of
/// pairs where they may not touch, to 0.01 mm, +infinity if there are none.
double judge_contacts(const RobotTable& robot, const Plan& plan, const Curve& curve,
                      ViolationRuns& runs);

}  // namespace morphe::verify
