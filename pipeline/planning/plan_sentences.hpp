#pragma once

#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"

namespace morphe::planning {

/// Joins sentences into one text, as in a plan's detail.
std::string join_sentences(const std::vector<std::string>& sentences);

/// Returns the warnings about an executable plan: tips without goals in some frames, a hand with
/// only one seen tip, meshes with holes, the delay of the timing in mode `kept`, phases with
/// uncertain borders (including a recording that is cut off in them), and the warnings of the
/// reconstruction.
std::string warnings(const collision::CollisionWorld& world, const Goals& goals,
                     const Movement& movement, const HumanMotion& motion,
                     const Trajectory& trajectory, bool kept);

/// Returns a warning that the pads touch but cannot hold the object, or "".
std::string grasp_force_warning(const Grasp& grasp);

/// Returns a warning that the upper arm's direction differs from the person's, or "".
std::string humanlikeness_warning(const Certificate& certificate, const Goals& goals);

}  // namespace morphe::planning
