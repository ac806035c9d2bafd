#pragma once

#include <string>
#include <vector>

#include "stages/grasp/closing_finger.hpp"

namespace morphe::grasp {

/// The result of close_fingers().
struct FingerClosures {
  std::vector<FingerClosure> closings;    ///< motions of the fingers that touch the target
  std::vector<std::string> open_reasons;  ///< a sentence for each finger that does not touch
};
/// Closes the fingers of `tips` one after another from posture q onto the target at `time_s`
/// (close_finger), in the manner that turns them least and lets them touch within kGoodPadAngle_rad
/// of the middle of the pad: abducted by up to 14 degrees to either side, with outer joints that
/// turn faster or slower than inner ones. If there is no such manner, the best one up to
/// kMaxContactAngle_rad is taken; else the finger stays open. A finger keeps the collision margin
/// from all bodies except the target and the fingers still to be closed.
FingerClosures close_fingers(const collision::CollisionWorld& world, double time_s,
                             const std::vector<std::size_t>& tips, JointVector q);

}  // namespace morphe::grasp
