#pragma once

#include "core/collision/world.hpp"
#include "stages/grasp/grasp_options.hpp"

namespace morphe::grasp {

/// A contact counts where the pad is this near to the surface [m].
inline constexpr double kTouches_m = 0.002;

/// What the contacts of a grasp are worth (docs/grasp_quality.md), and a squeeze by them: fills
/// `quality`, the contacts' forces, `squeeze_torque` and `squeeze_posture`. Contacts that do not
/// touch are left out; without two that do, the quality is not known (NaN). There is no squeeze
/// where no forces inside the cones balance.
/// Torques of the joints are those of forces at the contacts' points (Jᵀ f, without the moments of
/// torsion, which are hundredths of them); `down`: of gravity, in the base frame, unit.
void judge_grasp(const collision::CollisionWorld& world, double time_s, const Vec3& down,
                 const GraspOptions& options, Grasp& grasp);

}  // namespace morphe::grasp
