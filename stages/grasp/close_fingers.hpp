#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stages/grasp/closing_finger.hpp"

namespace morphe::grasp {

/// A finger that does not touch the target, and why: the end of a sentence.
struct OpenFinger {
  std::size_t tip = 0;
  std::string reason;
};
/// The result of close_fingers().
struct FingerClosures {
  std::vector<FingerClosure> closings;  ///< motions of the fingers that touch the target
  std::vector<OpenFinger> open;         ///< the other fingers
};
/// Closes the fingers of `tips` one after another from posture q onto the target at `time_s`
/// (close_finger), in the manner that turns them least and lets them touch within kGoodPadAngle_rad
/// of the middle of the pad: abducted by up to 14 degrees to either side, with outer joints that
/// turn faster or slower than inner ones. If there is no such manner, the best one up to
/// kMaxContactAngle_rad is taken; else the finger stays open. A finger keeps the collision margin
/// from all bodies except the target and the fingers still to be closed.
FingerClosures close_fingers(const collision::CollisionWorld& world, double time_s,
                             const std::vector<std::size_t>& tips, JointVector q);

/// A finger that closes by itself, and the fingers that may still move out of its way.
struct FingerInHand {
  std::size_t tip = 0;
  std::vector<std::size_t> unclosed;  ///< tips of fingers not yet closed
};

/// Closes one finger from q, near the target, as straight as it is (close_finger without another
/// manner). Returns nullopt if its pad does not touch, or the finger collides.
std::optional<FingerClosure> close_straight(const collision::CollisionWorld& world, double time_s,
                                            const FingerInHand& finger, const JointVector& q);

/// Returns true if a finger moves freely from its posture in `open` to that in `closed`, which
/// differ in its joints alone: on a straight line in joint space, it keeps the margin from all
/// bodies but the target, its links stay outside of the target, and its pad stays outside to within
/// the allowed penetration.
bool closes_freely(const collision::CollisionWorld& world, double time_s,
                   const FingerInHand& finger, const JointVector& open, const JointVector& closed);

}  // namespace morphe::grasp
