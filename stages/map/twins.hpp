#pragma once

#include <vector>

#include "stages/map/mapping_problem.hpp"

namespace morphe::map {

/// Postures that the objective cannot tell apart, because they place every link alike: where the
/// axes of three joints in a row meet as in a shoulder (the first and the last can be made parallel
/// by the middle one, which is square to both),
///   (q_first, q_middle, q_last) ~ (q_first + π, 2 parallel - q_middle, q_last + π),
/// and every joint's whole turns. A search need look at one of them alone, unless a limit is in the
/// way of it. Of a robot with very many of them, some.
struct Twins {
  struct Flip {
    Eigen::Index first, middle, last;
    double parallel;  ///< the middle joint's position at which the outer axes are parallel [rad]
  };
  std::vector<Flip> flips;
  std::vector<Eigen::Index> turning;  ///< joints that can make more than a whole turn
  JointVector lower, upper;           ///< [n] limits of the robot
};

/// The flips of the problem's robot that leave its objective as it is, which is tried at single
/// postures and frames.
Twins find_twins(const MappingProblem& problem);

/// The joints in which twins differ.
std::vector<Eigen::Index> joints_of(const Twins& twins);

/// Nearer than this in every joint, two postures are minima of one basin [rad].
inline constexpr double kSame = 0.1;

/// Whether a is b or one of b's twins, nearer than `tolerance` in every joint [rad].
bool alike(const Twins& twins, const JointVector& a, const JointVector& b, double tolerance);

/// q and its twins, those within the limits; the farthest from them first.
std::vector<JointVector> twins_of(const Twins& twins, const JointVector& q);

}  // namespace morphe::map
