#pragma once

#include <cstdint>

#include "core/collision/world.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// Plans a free path between two postures in the scene as it is at `time_s`: RRT-Connect with
/// certified edges, first the arm with the fingers in proportion, then all joints; shortened, and
/// pulled towards the straight line as far as it stays free. Samples are at most 0.02 rad apart,
/// all with SampleOrigin::planned; demonstration_time increases by 0.01 s per sample from `time_s`
/// and is only a label. The extra clearance is used if both ends have it. Returns a path without
/// samples if options.attempts attempts of options.iterations iterations did not find one. Depends
/// only on its arguments.
JointPath plan_transit(const collision::CollisionWorld& world, const JointVector& from,
                       const JointVector& to, double time_s, const RepairOptions& options,
                       std::uint64_t seed);

}  // namespace morphe::repair
