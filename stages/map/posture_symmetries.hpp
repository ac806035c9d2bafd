#pragma once

#include <vector>

#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// The symmetries of the robot's postures: equivalent postures have the same objective. There are
/// two kinds. A flip exists if the axes of three consecutive joints meet as in a shoulder (the
/// middle one is orthogonal to both others and can make them parallel):
///   (q_first, q_middle, q_last) ~ (q_first + π, 2 parallel - q_middle, q_last + π).
/// A whole turn exists for every joint whose range allows it. A search needs only one of equivalent
/// postures, unless a limit stops the path from it. At most kMaxFlips flips and kMaxMultiTurnJoints
/// joints are included.
struct PostureSymmetries {
  /// Three consecutive joints with two sets of positions that move all later links alike.
  struct SphericalFlip {
    int first, middle, last;
    double parallel_rad;  ///< position of the middle joint at which the outer axes are parallel
  };
  std::vector<SphericalFlip> flips;             ///< flips that preserve the objective
  std::vector<Eigen::Index> multi_turn_joints;  ///< joints with a range of more than a whole turn
  JointVector lower, upper;                     ///< [n] limits of the robot
};

/// Returns the symmetries of the robot that preserve the objective at a few postures and frames.
PostureSymmetries find_posture_symmetries(const MappingProblem& problem);

/// Returns the joints in which equivalent postures differ.
std::vector<Eigen::Index> symmetry_joints(const PostureSymmetries& symmetries);

/// Returns true if a is b or equivalent to b, within `tolerance` in every joint [rad].
bool same_up_to_symmetry(const PostureSymmetries& symmetries, const JointVector& a,
                         const JointVector& b, double tolerance);

/// Returns q and its equivalent postures within the limits, those farthest from the limits first.
std::vector<JointVector> equivalent_postures(const PostureSymmetries& symmetries,
                                             const JointVector& q);

}  // namespace morphe::map
