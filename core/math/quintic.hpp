#pragma once

#include <array>

#include "core/motion/plan.hpp"

namespace morphe::math {

/// The trajectory of one joint between two samples: the quintic that meets position, velocity and
/// acceleration at both ends, p(t) = sum_k coefficient[k] z^k with z = t / duration in [0, 1].
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
QuinticPiece quintic_piece(const Trajectory& trajectory, Eigen::Index sample, Eigen::Index joint);

/// Returns the cubic Hermite piece of a joint between samples `sample` and `sample` + 1: it meets
/// position and velocity at both ends, and its acceleration is linear.
QuinticPiece cubic_piece(const Trajectory& trajectory, Eigen::Index sample, Eigen::Index joint);

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
/// Bounds of every joint between two samples from Bézier points: fast, but wider than the extremes.
struct Enclosure {
  Eigen::ArrayXd lowest, highest;               ///< [joints] bounds of the position
  Eigen::ArrayXd velocity, acceleration, jerk;  ///< [joints] bounds of the magnitudes
};
/// Computes the bounds between samples `sample` and `sample` + 1.
void enclose(const Trajectory& trajectory, Eigen::Index sample, Enclosure& enclosure);

/// Returns how far the piece's position leaves [lower, upper] at most, exactly; 0 if it does not.
double limit_excess(const QuinticPiece& piece, double lower, double upper);

}  // namespace morphe::math
