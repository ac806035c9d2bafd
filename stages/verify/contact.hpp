#pragma once

#include <vector>

#include "core/motion/robot_model.hpp"
#include "stages/verify/clearance_by_kind.hpp"
#include "stages/verify/curve.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {

/// A capsule and another body: an object of the scene if `is_object` is true, else a capsule.
struct ContactPair {
  int capsule = 0, other = 0;
  bool is_object = false;
  bool may_touch = false;    ///< true for a finger or the palm against the target
  bool is_pad = false;       ///< true if the capsule belongs to a pad
  double radius_sum = 0;     ///< of the capsules, subtracted from the distance of their axes [m]
  JointVector motion_bound;  ///< [n] relative travel per radian [m/rad]
  std::string subject;       ///< "capsule/capsule" or "capsule/object"
};

/// The time during which the target may be touched: from the first preshape (or the grasp, if there
/// is no preshape) to the end of the last grasp, hold or transport, with 1e-9 s for rounding at
/// either border [demonstration time, s]. Empty if these phases are missing.
struct TouchWindow {
  double begin_s = 1, end_s = 0;
  /// Returns true if the interval [from_s, to_s] lies within the window.
  bool contains(double from_s, double to_s) const { return from_s >= begin_s && to_s <= end_s; }
};
/// Returns the touch window of a movement's phases.
TouchWindow touch_window(const std::vector<Phase>& phases);

/// Returns all pairs of capsules except the allowed collisions and the pairs whose relative pose is
/// fixed (on one frame, or both at the base), followed by each capsule with each object for which
/// has_valid_shape() holds.
std::vector<ContactPair> contact_pairs(const RobotModel& robot, const Plan& plan);

/// Records `self_collision` and `object_collision` violations, at the samples and along the curve
/// between them, if a pair is closer than the plan's required_clearance. A pair that may touch in
/// the touch window may penetrate by max_penetration there, or by max_link_penetration if the plan
/// has one and the capsule is no pad. Records `clearance` violations if the clearance stored for a
/// sample differs from the recomputed one by more than 1e-4 m, and the violations of
/// verify_carried_object(). Returns the least distance along the
/// whole curve, to 0.01 mm, over all pairs of each kind at times at which they may not touch.
/// Compares the pair and the time of each of the certificate's clearances by kind with the distance
/// of that pair at that time (`certificate`), if the curve is that of the plan's trajectory.
ClearanceByKind verify_contacts(const RobotModel& robot, const Plan& plan, const Curve& curve,
                                ViolationLog& violations);

}  // namespace morphe::verify
