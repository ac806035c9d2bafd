#pragma once

#include <vector>

#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// The symmetries of the robot's postures that the objective cannot distinguish, because they place
/// every link alike. If the axes of three consecutive joints meet as in a shoulder (the middle
/// joint is orthogonal to both others and can make them parallel), then
///   (q_first, q_middle, q_last) ~ (q_first + π, 2 parallel - q_middle, q_last + π),
/// and the same holds for whole turns of every joint. A search only needs to consider one of these
/// postures, unless it is stopped by a limit. For a robot with very many symmetries, only some are
/// included.
struct PostureSymmetries {
  /// A pair of postures of three consecutive joints with the same link poses.
  struct SphericalFlip {
    Eigen::Index first, middle, last;  ///< the three joints
    /// Position of the middle joint at which the outer axes are parallel [rad].
    double parallel_rad;
  };
  std::vector<SphericalFlip> flips;             ///< flips that preserve the objective
  std::vector<Eigen::Index> multi_turn_joints;  ///< joints with a range of more than a whole turn
  JointVector lower, upper;                     ///< [n] limits of the robot
};

/// Returns the flips of the problem's robot that preserve its objective, which is tested at a few
/// postures and frames.
PostureSymmetries find_posture_symmetries(const MappingProblem& problem);

/// Returns the joints in which equivalent postures differ.
std::vector<Eigen::Index> symmetry_joints(const PostureSymmetries& twins);

/// Distance in every joint below which two postures are minima of one basin [rad].
inline constexpr double kBasinTolerance_rad = 0.1;

/// Returns true if a is b or equivalent to b, within `tolerance` in every joint [rad].
bool same_up_to_symmetry(const PostureSymmetries& twins, const JointVector& a, const JointVector& b,
                         double tolerance);

/// Returns q and its equivalent postures that are within the limits; those farthest from the limits
/// come first.
std::vector<JointVector> equivalent_postures(const PostureSymmetries& twins, const JointVector& q);

}  // namespace morphe::map
