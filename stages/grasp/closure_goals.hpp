#pragma once

#include <vector>

#include "stages/grasp/closing_finger.hpp"

namespace morphe::grasp {

/// Returns the tips of fingers that have a pad and no goal while the target is held.
std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldInterval& hold);

/// Sets goals for the tips of closed fingers. While closing_progress() is between 0 and 1, that
/// share of `turn` is added to the posture in `path` [F, n], and the goal of the pad follows the
/// forward kinematics. At 1, the pad stays on the target. From the release on there is no goal, so
/// that the finger returns to its natural posture.
void set_closure_goals(const robot::Robot& robot, const std::vector<FingerClosure>& closings,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals);

}  // namespace morphe::grasp
