#pragma once

#include <cstdint>

#include "core/collision/world.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// Plans a free path from `from` to `to`, which is clamped to the joint limits, in the scene as it
/// is at `time_s`. RRT-Connect with certified edges moves first the arm with the fingers in
/// proportion, then all joints. The path is shortened and pulled towards the straight line as far
/// as it stays free. Its steps are about kMaxTransitStep_rad or shorter; demonstration_time, from
/// `time_s` on, is only a label. The clearance is the margin plus the largest of
/// kExtraClearanceShares of options.extra_clearance that both ends have, or else the margin alone.
/// Returns a path without samples if none was found. The result depends only on the arguments.
JointPath plan_transit(const collision::CollisionWorld& world, const JointVector& from,
                       const JointVector& to, double time_s, const RepairOptions& options,
                       std::uint64_t seed);

}  // namespace morphe::repair
