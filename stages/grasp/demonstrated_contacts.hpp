#pragma once

#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Returns the contacts that the person's fingertips made with the target. A tip of the robot with
/// goals and a pad touches in the frames of grasp and hold in which the skin (pad_depth_m from the
/// goal) is within touch_distance_m of the surface, or deeper. Its contact is the point of the
/// surface nearest to the mean of the surface points nearest to its goals in these frames. It has
/// no contact if these frames are less than min_contact_share of those in which it has a goal. The
/// confidence is that share times exp(-mean |gap| / touch_distance_m).
std::vector<DesiredContact> demonstrated_contacts(const robot::Robot& robot, const Goals& goals,
                                                  const Movement& movement,
                                                  const collision::Solid& target,
                                                  const GraspOptions& options);

/// Moves contacts along the surface, no further than needed, until the spheres of all pads, which
/// are wider than a person's, are `margin_m` apart (to 0.1 mm) or after 50 rounds.
void separate_contacts(const robot::Robot& robot, const collision::Solid& target, double margin_m,
                       std::vector<DesiredContact>& touches);

/// Returns the same contact at the surface point nearest to `point` [target frame, m].
DesiredContact project_contact(const robot::Robot& robot, const collision::Solid& target,
                               const Vec3& point, DesiredContact touch);

/// Returns a contact, or, if it is farther than kMaxSlide_m from the demonstrated point, one on the
/// way there that is not.
DesiredContact limit_slide(const robot::Robot& robot, const collision::Solid& target,
                           const DesiredContact& touch);

/// Sets goals that bring the pads to their contacts. During the preshape the goal of each tip is
/// blended by share = closing_progress() from the human tip to the centre of the pad's sphere
/// beside the surface, and back after the release. While it is blended, the goal stays outside the
/// target by at least
///   sqrt(share) radius + 4 share (1 - share) aperture_m,
/// because a finger also approaches from the side, and the hand opens around the target before it
/// closes. After the release it stays outside by at least
///   radius + (1 - share) kLeavingGap_m,
/// because a robot's pads are thicker than a person's, and would drag the target along.
void set_pad_goals(const robot::Robot& robot, const std::vector<DesiredContact>& touches,
                   const Movement& movement, const collision::Solid& target, double aperture_m,
                   Goals& goals);

/// Keeps the goals of tips without a contact outside the target by the radius of their pads, which
/// are thicker than a person's, times the square root of closing_progress().
void keep_goals_outside(const robot::Robot& robot, const std::vector<std::size_t>& tips,
                        const Movement& movement, const collision::Solid& target, Goals& goals);

}  // namespace morphe::grasp
