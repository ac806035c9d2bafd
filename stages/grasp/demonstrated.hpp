#pragma once

#include "stages/grasp/touch.hpp"

namespace morphe::grasp {

/// Where the person's fingertips touched the target: for each of the robot's tips that has goals
/// and a pad, the nearest point of the surface to its goals, in the mean over the frames of grasp
/// and hold in which the skin (pad_depth from the goal) lies within `near` of it; none where that
/// is less than least_share of the frames in which it was seen. Confidence: that share, times how
/// near. Of a target that was inferred from the tips the distance is zero by construction.
std::vector<Touch> demonstrated_touches(const robot::Robot& robot, const Goals& goals,
                                        const Movement& movement, const collision::Solid& target,
                                        const GraspOptions& options);

/// Moves touches along the surface, no further than needed, until the pads' balls of neighbouring
/// fingers are `margin_m` apart: a robot's fingers are wider than a person's.
void make_room(const robot::Robot& robot, const collision::Solid& target, double margin_m,
               std::vector<Touch>& touches);

/// The same touch at the surface's point nearest to `near` [target frame, m].
Touch moved_to(const robot::Robot& robot, const collision::Solid& target, const Vec3& near,
               Touch touch);

/// Goals that bring pads to where they touch: over the preshape the goal of each tip goes over from
/// the tip where the person's was to the centre of the pad's ball beside the surface, and back
/// after the release (closed_share()). On its way a goal stays outside the target by
/// sqrt(share) radius + 4 share (1 - share) aperture: a finger comes from the side as well, and the
/// hand opens around what it is to take before it closes. The target is where it was recorded; in a
/// hand that carries it by its palm the way from tip to pad stays what it was as it was taken.
void aim_pads(const robot::Robot& robot, const std::vector<Touch>& touches,
              const Movement& movement, const collision::Solid& target, double aperture_m,
              Goals& goals);

/// Keeps the goals of tips that are not to touch as far outside of the target as their pads are
/// thick (closed_share() of it): a person's fingertip beside what others hold is thinner than a
/// robot's, and the shape that it lies against less exact.
void keep_outside(const robot::Robot& robot, const std::vector<std::size_t>& tips,
                  const Movement& movement, const collision::Solid& target, Goals& goals);

}  // namespace morphe::grasp
