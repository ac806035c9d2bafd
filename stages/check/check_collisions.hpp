#pragma once

#include "stages/check/check_path.hpp"
#include "stages/check/finding_rows.hpp"

namespace morphe::check {

/// Adds the findings with the causes self, object and table for check_path().
void check_collisions(const collision::CollisionWorld& world, const JointPath& path, Engine engine,
                      FindingRows& rows);

}  // namespace morphe::check
