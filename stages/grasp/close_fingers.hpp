#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// The closing motion of a finger from its open posture to its contact with the object.
struct FingerClosure {
  DesiredContact contact;  ///< contact of the pad with the target
  JointVector turn;        ///< [n] change of the joint positions from open to touching [rad]
};

/// Returns the joints of the tip's finger that move its pad forward (along the pad's direction),
/// each with the sign of its closing direction.
std::vector<std::pair<int, double>> closing_joints(const robot::Robot& robot, const JointVector& q,
                                                   std::size_t tip);

/// The result of close_fingers().
struct FingerClosures {
  /// The fingers that touch the target.
  std::vector<FingerClosure> closings;
  std::vector<std::string> open_reasons;  ///< a sentence for each finger that does not touch
};
/// Closes the fingers of `tips` one after another from posture q onto the target. The closing
/// joints of a finger turn at one rate within their limits; joints before a link that touches stop
/// and the others continue until the pad touches (a contact) or no joint moves any more. A finger
/// keeps the collision margin from all bodies except the fingers that are still to be closed. If it
/// cannot, or does not reach the target, it is abducted by 7 or 14 degrees to either side; if that
/// fails too, it stays open.
FingerClosures close_fingers(const collision::CollisionWorld& world, double time_s,
                             const std::vector<std::size_t>& tips, JointVector q);

/// Returns the tips of fingers that have a pad and no goal while the target is held.
std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldInterval& when);

/// Sets goals for the tips of closed fingers. During the preshape the closing joints turn
/// progressively from their positions in `path` [F, n], and the goal of the pad follows their
/// forward kinematics; after that the pad stays on the target.
void set_closure_goals(const robot::Robot& robot, const std::vector<FingerClosure>& closings,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals);

}  // namespace morphe::grasp
