#pragma once

#include "core/collision/world.hpp"
#include "stages/check/finding_rows.hpp"

namespace morphe::check {

/// Adds the findings self, object and table of check_path() by exact distances, with the straight
/// lines between samples certified.
void check_certified(const collision::CollisionWorld& world, const JointPath& path,
                     FindingRows& rows);
/// Adds the same findings by FCL, at instants between which no body travels farther than the margin
/// (or 0.5 mm, if the margin is smaller).
void check_with_fcl(const collision::CollisionWorld& world, const JointPath& path,
                    FindingRows& rows);

}  // namespace morphe::check
