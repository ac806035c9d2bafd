#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// The closing motion of a finger from its open posture to its contact with the target.
struct FingerClosure {
  DesiredContact contact;
  JointVector turn;  ///< [n] change of the joint positions from open to touching [rad]
};

/// Returns the joints of the tip's finger that move its pad along the pad's direction by more than
/// kMinLeverRatio of the joint that does so most, each with the sign (1 or -1) in which it closes.
std::vector<std::pair<int, double>> closing_joints(const robot::Robot& robot, const JointVector& q,
                                                   std::size_t tip);

/// The result of close_fingers().
struct FingerClosures {
  std::vector<FingerClosure> closings;    ///< motions of the fingers that touch the target
  std::vector<std::string> open_reasons;  ///< a sentence for each finger that does not touch
};
/// Closes the fingers of `tips` one after another from posture q onto the target at `time_s`. The
/// closing joints of a finger turn at one rate within their limits. When a link touches, the joints
/// that move it stop; the others continue until the pad touches or no joint moves any more. A
/// finger keeps the collision margin from all bodies except the target and the fingers still to be
/// closed. If it cannot, or does not touch the target, it is tried again abducted by 7 or 14
/// degrees to either side; if all fail, it stays open.
FingerClosures close_fingers(const collision::CollisionWorld& world, double time_s,
                             const std::vector<std::size_t>& tips, JointVector q);

/// Returns the tips of fingers that have a pad and no goal while the target is held.
std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldInterval& hold);

/// Sets goals for the tips of closed fingers. While closing_progress() is between 0 and 1, that
/// share of `turn` is added to the posture in `path` [F, n], and the goal of the pad follows the
/// forward kinematics. At 1, the pad stays on the target or, once the target is attached to the
/// palm, follows the kinematics too.
void set_closure_goals(const robot::Robot& robot, const std::vector<FingerClosure>& closings,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals);

}  // namespace morphe::grasp
