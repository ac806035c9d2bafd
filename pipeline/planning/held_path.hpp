#pragma once

#include "core/motion/geometry.hpp"
#include "stages/grasp/desired_contact.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// Adds to a problem that joints keep the positions `held` [n] while the hand holds the target
/// (grasp::is_held_at), by the term JointAngle with a weight [1/rad²]. A joint with NaN is free.
void hold_joints(const grasp::HoldInterval& hold, const JointVector& held, double weight,
                 map::MappingProblem& problem);

/// Sets the frames of `path` [F, n] from `grasp_frame` on to solutions of `problem`, each found
/// from the one before, the first from `held`. They also continue after the release, because the
/// arm may be in another branch by then than a path that follows the tips alone.
void follow_target(const map::MappingProblem& problem, std::size_t grasp_frame,
                   const JointVector& held, const map::MapOptions& options, JointRows& path);

}  // namespace morphe::planning
