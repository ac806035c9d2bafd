#pragma once

#include "stages/map/join_ik_branches.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Returns the posture [n] in the first frame to which one for the person at rest (Reference)
/// leads: the goals move from those at rest to those of the frame in kRestSteps steps, the hand
/// along the shortest turn and the tips with it, while the clearance grows to its weight. Each
/// solve begins at the posture before and stays near it, so that the result depends continuously on
/// the goals.
JointVector posture_from_rest(const MappingProblem& problem, const JointVector& posture,
                              const MapOptions& options, MappingScratch& scratch);

/// Continues a posture [n] for the person at rest into a movement: to the first frame by
/// posture_from_rest(), and from there, in the same way, from frame to frame.
IkBranch continue_from_rest(const MappingProblem& problem, const JointVector& posture,
                            const MapOptions& options, MappingScratch& scratch);

}  // namespace morphe::map
