#pragma once

#include <vector>

#include "core/robot/spherical_flips.hpp"
#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// The symmetries of the robot's postures: equivalent postures have the same objective. There are
/// two kinds: a flip (core/robot/spherical_flips.hpp) exists if the axes of three consecutive
/// joints meet as in a shoulder; a whole turn exists for every joint whose range allows it. A
/// search needs only one of equivalent postures, unless a limit stops the path from it. At most
/// kMaxFlips flips are included. The turns of a joint are chosen apart from those of the others.
struct PostureSymmetries {
  std::vector<robot::SphericalFlip> flips;      ///< flips that preserve the objective
  std::vector<Eigen::Index> multi_turn_joints;  ///< joints with a range of more than a whole turn
  JointVector lower, upper;                     ///< [n] limits of the robot
  JointVector reference;  ///< [n] posture to which equivalent ones are near, or empty
};

/// Returns the symmetries of the robot that preserve the objective at a few postures and frames.
PostureSymmetries find_posture_symmetries(const MappingProblem& problem);

/// Returns the flips of the arm that leave the palm where it is, within kSamePlace_m and
/// kSameTurn_rad, whole turns as above. Links between may then be elsewhere, so that the objective
/// of a collision differs: a flipped posture is one to begin with, not an equal one.
PostureSymmetries find_palm_symmetries(const MappingProblem& problem);

/// Returns the joints in which equivalent postures differ.
std::vector<Eigen::Index> symmetry_joints(const PostureSymmetries& symmetries);

/// Returns true if a is b or equivalent to b, within `tolerance` in every joint [rad].
bool same_up_to_symmetry(const PostureSymmetries& symmetries, const JointVector& a,
                         const JointVector& b, double tolerance);

/// Returns q and its flipped postures within the limits, each joint turned towards the reference:
/// those nearest to it first, or, without one, those farthest from the limits.
std::vector<JointVector> equivalent_postures(const PostureSymmetries& symmetries,
                                             const JointVector& q);

/// Returns the path [F, n] with every joint moved by whole turns to where it is nearest to the
/// reference or, without one, to the middle of its range. It is not wound up (robot::wound_turns)
/// unless the reference is, and inside its limits if a turn is.
JointRows turned_towards_reference(const PostureSymmetries& symmetries, JointRows path);

/// Returns a posture q of a path [F, n] whose joints are turned away from limits that the path
/// reaches; q itself if no range allows that.
JointVector turned_off_limits(const PostureSymmetries& symmetries, const JointRows& path,
                              JointVector q);

/// Returns the equivalent of a path [F, n], within the limits in all frames, whose flips have the
/// sides of the reference or, with the same number of them, that is nearest to it, turned towards
/// it; without a reference, the path turned.
JointRows preferred_equivalent(const PostureSymmetries& symmetries, const JointRows& path);

}  // namespace morphe::map
