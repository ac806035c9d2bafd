#pragma once

#include <vector>

#include "core/motion/geometry.hpp"
#include "stages/grasp/desired_contact.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::planning {

/// The posture at a grasp, and its contacts where its pads are nearest to the target.
struct ContactPosture {
  JointVector q;  ///< [n]
  std::vector<grasp::DesiredContact> contacts;
};

/// Returns the posture of `frame` in which the pads of `contacts` touch the target with their
/// middles, near the person's points (grasp::SurfaceContactTerm), and these contacts, moved to
/// where its pads touch. The goals of `problem` pull each pad to its desired contact with
/// kSlideWeight_per_m2. `stay` [n] are the weights that keep each joint at `start` [1/rad²]. The
/// posture is the best of the minima found from `start` and from kContactStarts others, in which
/// the joints without such a weight differ.
ContactPosture solve_contact_posture(const map::MappingProblem& problem, std::size_t frame,
                                     const std::vector<grasp::DesiredContact>& contacts,
                                     const JointVector& start, const JointVector& stay,
                                     const map::MapOptions& options, std::uint64_t seed);

}  // namespace morphe::planning
