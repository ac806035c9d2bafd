#pragma once

#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "core/motion/plan.hpp"

namespace morphe::planning {

/// Sentences one after the other, as a plan's detail has them.
std::string joined(const std::vector<std::string>& sentences);

/// What a user must know of an executable plan: tips whose goals are missing in some frames, a hand
/// of which one tip alone was seen, meshes with holes, how late it is where tempo is `kept`, phases
/// that may begin or end elsewhere (a recording that is cut off in them), and what reconstruction
/// had to complain of.
std::string warnings(const collision::CollisionWorld& world, const Goals& goals,
                     const Movement& movement, const HumanMotion& motion,
                     const Trajectory& trajectory, bool kept);

/// "", or that pads touch but cannot hold.
std::string no_squeeze(const Grasp& grasp);

/// "", or that the upper arm points elsewhere than the person's.
std::string not_humanlike(const Certificate& certificate, const Goals& goals);

}  // namespace morphe::planning
