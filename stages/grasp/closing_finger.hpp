#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/collision/world.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// The closing motion of a finger from its open posture to its contact with the target.
struct FingerClosure {
  DesiredContact contact;
  double pad_angle_rad = 0;  ///< between the middle of the pad and the surface's normal
  JointVector turn;          ///< [n] change of the joint positions from open to touching [rad]
};

/// Returns the joints of the tip's finger that move its pad along the pad's direction by more than
/// kMinLeverRatio of the joint that does so most, each with the sign (1 or -1) in which it closes.
std::vector<std::pair<int, double>> closing_joints(const robot::Robot& robot, const JointVector& q,
                                                   std::size_t tip);

/// Distance queries for one finger at one posture.
struct FingerProbe {
  const collision::CollisionWorld& world;
  std::vector<int> finger_capsules;  ///< capsules of the finger
  /// The pairs of `world` of a capsule of the finger and another body of the robot, without fingers
  /// not yet closed: the mapping moves them aside.
  std::vector<std::array<int, 2>> pairs;
  Pose base_from_target;
  collision::CollisionScratch scratch;

  /// Moves the robot to a posture [n] at a time.
  void pose(const JointVector& q, double time_s);
  /// Returns the separation of a capsule from the target.
  collision::Separation separation_from_target(int capsule) const;
  /// Returns the name of a body, not the target, that is nearer to the finger than the margin, or
  /// "".
  std::string find_obstacle() const;
};

/// A way to close a finger: the angle by which the joints that do not close it are turned first,
/// and by how much the outer joints turn faster than the inner ones (-1: the innermost alone,
/// 1: the outermost alone).
struct ClosingManner {
  double abduction_rad = 0, curl = 0;
};

/// Closes one finger from q [n] at `time_s`. Its joints turn at constant rates within their limits.
/// When a link touches the target, the joints that move it stop; the others continue until the pad
/// touches. Without a contact, or if the finger collides, returns nullopt and sets `reason`.
std::optional<FingerClosure> close_finger(FingerProbe& probe, double time_s, std::size_t tip,
                                          const ClosingManner& manner, const JointVector& q,
                                          std::string& reason);

}  // namespace morphe::grasp
