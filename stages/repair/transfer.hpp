#pragma once

#include <cstdint>

#include "core/collision/world.hpp"
#include "stages/repair/repair_options.hpp"

namespace morphe::repair {

/// A free path between two postures while everything else stands as it does at `time_s`:
/// RRT-Connect with certified edges, the arm first and the fingers in proportion, then all joints;
/// shortened, and drawn towards the straight line as far as it stays free. Samples lie at most
/// 0.02 rad apart, all Origin::planned; demonstration_time is 0.01 s a sample from `time_s`, a
/// label alone. With extra clearance where both ends have it. No samples if none was found in
/// options.attempts of options.iterations. Depends on its arguments alone.
JointPath plan_transfer(const collision::CollisionWorld& world, const JointVector& from,
                        const JointVector& to, double time_s, const RepairOptions& options,
                        std::uint64_t seed);

}  // namespace morphe::repair
