#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/touch.hpp"

namespace morphe::grasp {

/// A finger on its way from where it is to the object.
struct Closing {
  Touch touch;
  JointVector turn;  ///< [n] from open to touching [rad]
};

/// The joints of a tip's finger that bring its pad forward (along the middle of the pad), with the
/// sign of that.
std::vector<std::pair<int, double>> closing_joints(const robot::Robot& robot, const JointVector& q,
                                                   std::size_t tip);

/// Closes fingers one after the other from posture q onto the target: their closing joints turn at
/// one rate, within their limits; those before a link that touches stop, the others go on, until
/// the pad touches (a contact) or nothing moves any more. A finger keeps the margin from everything
/// else but the fingers that are still to be closed; where it cannot, or does not reach, it is
/// spread by 7 or 14 degrees to either side, and otherwise stays where it is. `tips`: to be closed.
struct ClosedFingers {
  std::vector<Closing> closings;
  std::vector<std::string> open;  ///< a sentence for each finger that does not touch
};
ClosedFingers close_fingers(const collision::CollisionWorld& world, double time_s,
                            const std::vector<std::size_t>& tips, JointVector q);

/// Tips of fingers that have a pad, and no goal while the target is held.
std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldTime& when);

/// Goals for tips without any: over the preshape the closing joints turn more and more from where
/// `path` [F, n] has them, and the pad is to be where they take it; then it stays on the target.
void aim_closings(const robot::Robot& robot, const std::vector<Closing>& closings,
                  const Movement& movement, const SceneObject& target, const JointRows& path,
                  Goals& goals);

}  // namespace morphe::grasp
