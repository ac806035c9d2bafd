#pragma once

#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Returns the contacts that the person's fingertips made with the target. For each of the robot's
/// tips that has goals and a pad, the contact is the point of the surface nearest to the mean of
/// the nearest points of its goals, over the frames of grasp and hold in which the skin (at
/// `pad_depth` from the goal) is within the option `near` of the surface. A tip has no contact if
/// it touches in less than `least_share` of the frames in which it was seen. The confidence is that
/// share times exp(-mean gap / near). For a target that was inferred from the tips the distance is
/// zero by construction.
std::vector<DesiredContact> demonstrated_contacts(const robot::Robot& robot, const Goals& goals,
                                                  const Movement& movement,
                                                  const collision::Solid& target,
                                                  const GraspOptions& options);

/// Moves contacts along the surface, no further than needed, until the pad spheres of neighbouring
/// fingers are `margin_m` apart. A robot's fingers are wider than a person's.
void separate_contacts(const robot::Robot& robot, const collision::Solid& target, double margin_m,
                       std::vector<DesiredContact>& touches);

/// Returns the same contact at the surface point nearest to `near` [target frame, m].
DesiredContact project_contact(const robot::Robot& robot, const collision::Solid& target,
                               const Vec3& near, DesiredContact touch);

/// Sets goals that bring the pads to their contacts. During the preshape the goal of each tip is
/// blended by closing_progress() from the human tip to the centre of the pad's sphere beside the
/// surface, and back after the release. In between, the goal stays outside the target by at least
/// sqrt(share) radius + 4 share (1 - share) aperture: a finger also approaches from the side, and
/// the hand opens around the target before it closes. The target has its recorded pose; if the hand
/// carries it as an object attached to its palm, the offset from tip to pad stays as it was when
/// the object was attached.
void set_pad_goals(const robot::Robot& robot, const std::vector<DesiredContact>& touches,
                   const Movement& movement, const collision::Solid& target, double aperture_m,
                   Goals& goals);

/// Keeps the goals of tips without a contact outside the target by the radius of their pads times
/// the square root of closing_progress(). A person's fingertip beside the touching ones is thinner
/// than a robot's, and the shape that it touches is less exact.
void keep_goals_outside(const robot::Robot& robot, const std::vector<std::size_t>& tips,
                        const Movement& movement, const collision::Solid& target, Goals& goals);

}  // namespace morphe::grasp
