#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::grasp {

/// Maximum gap between a pad and the surface that counts as a contact [m].
inline constexpr double kMaxContactGap_m = 0.002;

/// Evaluates the quality of a grasp (docs/grasp_quality.md) and computes squeeze forces for it.
/// Fills `quality`, the forces of the contacts, `grasp_torque` and `servo_target`. Contacts
/// that do not touch are left out; with fewer than two touching contacts the quality is unknown
/// (NaN). There is no squeeze if no forces inside the friction cones balance.
///
/// The joint torques are those of forces at the contact points (Jᵀ f, without the torsional
/// moments, which are about a hundredth of them). `down` is the unit direction of gravity in the
/// base frame.
void evaluate_grasp(const collision::CollisionWorld& world, double time_s, const Vec3& down,
                    const GraspOptions& options, Grasp& grasp);

}  // namespace morphe::grasp
