#pragma once

#include <array>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::math {

/// The trajectory of one joint between two samples: the quintic polynomial that interpolates
/// position, velocity and acceleration at both ends. p(t) = sum_k coefficient[k] z^k with z = t /
/// duration in [0, 1].
struct QuinticPiece {
  std::array<double, 6> coefficient{};
  double duration = 1;  ///< [s], > 0
};

/// The position, velocity and acceleration of a joint at one end of a piece.
struct JointState {
  double position = 0, velocity = 0, acceleration = 0;
};

/// Returns the piece between two states.
QuinticPiece quintic_piece(const JointState& begin, const JointState& end, double duration);
/// Returns the piece of a joint between samples `sample` and `sample` + 1.
QuinticPiece quintic_piece(const Trajectory& trajectory, std::size_t sample, Eigen::Index joint);

/// Returns the derivative of order 0 (position) to 3 (jerk) at t in [0, duration] [rad/s^order].
double value_at(const QuinticPiece& piece, double t, int order = 0);

/// A range of values.
struct Range {
  double least = 0, greatest = 0;
};
/// The exact minimum and maximum of each derivative over a piece.
struct QuinticExtremes {
  Range position, velocity, acceleration, jerk;
};
/// Computes the extremes over a whole piece.
QuinticExtremes extremes(const QuinticPiece& piece);
/// Computes the extremes over [from_s, to_s] only.
QuinticExtremes extremes(const QuinticPiece& piece, double from_s, double to_s);
/// Bounds of every joint between two samples, from the Bézier points that enclose each curve. They
/// contain the exact extremes and are fast to compute.
struct Enclosure {
  Eigen::ArrayXd lowest, highest;               ///< [joints] bounds of the position
  Eigen::ArrayXd velocity, acceleration, jerk;  ///< [joints] bounds of the magnitudes
};
/// Computes the bounds between samples `sample` and `sample` + 1.
void enclose(const Trajectory& trajectory, std::size_t sample, Enclosure& enclosure);

/// Returns the largest exact distance of the piece's positions beyond [lower, upper], or 0 if they
/// are within.
double limit_excess(const QuinticPiece& piece, double lower, double upper);

/// The largest |value| / limit over all joints and the whole trajectory, evaluated on the quintic
/// polynomials (for velocity including the braking curves); `sample` is the one before the maximum,
/// -1 for an empty trajectory.
struct LimitUse {
  double ratio = 0;
  int sample = -1, joint = -1;
};
/// The use of all limits by a trajectory.
struct LimitReport {
  LimitUse velocity, acceleration, jerk;
  /// Smallest distance to a position limit, < 0 if exceeded [rad].
  double position_margin = kUnknown;
  int margin_sample = -1, margin_joint = -1;
};
/// Computes the use of all limits by a trajectory.
LimitReport limit_report(const RobotModel& robot, const Trajectory& trajectory);

}  // namespace morphe::math
