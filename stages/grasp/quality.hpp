#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/constants.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::grasp {

/// Evaluates the quality of a grasp (docs/grasp_quality.md) and computes squeeze forces for it.
/// Fills `quality`, the forces of the contacts, `grasp_torque` (Jᵀ f, without the torsional
/// moments, which are about a hundredth of it) and `servo_target`. `grasp` has its posture and
/// contacts. Contacts whose pad is farther from the surface than kMaxContactGap_m are left out;
/// with fewer than two others the quality is unknown (NaN). Without forces inside the friction
/// cones that balance, forces, grasp_torque and servo_target remain empty. `down` is the direction
/// of gravity in the base frame.
void evaluate_grasp(const collision::CollisionWorld& world, double time_s, const Vec3& down,
                    const GraspOptions& options, Grasp& grasp);

}  // namespace morphe::grasp
