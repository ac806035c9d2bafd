#pragma once

#include "stages/check/check_path.hpp"
#include "stages/check/finding_rows.hpp"

namespace morphe::check {

/// The causes self, object and table of check_path().
void check_collisions(const collision::CollisionWorld& world, const JointPath& path, Engine engine,
                      FindingRows& rows);

}  // namespace morphe::check
