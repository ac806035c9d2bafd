#pragma once

#include <vector>

#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Returns the tips of fingers that have a pad and no goal while the target is held.
std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldInterval& hold);

/// Sets goals for the tips of `contacts` whose fingers close by themselves, from a path [F, n] that
/// closes them: from the preshape on, the goal of a pad follows the path's forward kinematics, and
/// where closing_progress() is 1, the pad stays on the target. From the release on there is no
/// goal, so that the finger returns to its natural posture.
void set_closure_goals(const robot::Robot& robot, const std::vector<DesiredContact>& contacts,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals);

}  // namespace morphe::grasp
