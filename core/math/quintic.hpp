#pragma once

#include <array>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::math {

/// One joint between two trajectory samples: the quintic that meets position, velocity and
/// acceleration at both ends. p(t) = sum_k coefficient[k] z^k with z = t / duration in [0, 1].
struct QuinticPiece {
  std::array<double, 6> coefficient{};
  double duration = 1;  ///< [s], > 0
};

/// Position, velocity and acceleration of one joint at one end of a piece.
struct JointState {
  double position = 0, velocity = 0, acceleration = 0;
};

QuinticPiece quintic_piece(const JointState& begin, const JointState& end, double duration);
/// Between samples `sample` and `sample` + 1.
QuinticPiece quintic_piece(const Trajectory& trajectory, std::size_t sample, Eigen::Index joint);

/// Derivative of an order from 0 (position) to 3 (jerk) at t in [0, duration] [rad/s^order].
double value_at(const QuinticPiece& piece, double t, int order = 0);

struct Range {
  double least = 0, greatest = 0;
};
/// Exact least and greatest value of each derivative over a piece.
struct QuinticExtremes {
  Range position, velocity, acceleration, jerk;
};
QuinticExtremes extremes(const QuinticPiece& piece);
/// Over [from_s, to_s] of it alone.
QuinticExtremes extremes(const QuinticPiece& piece, double from_s, double to_s);
/// What every joint keeps to between two samples, by the Bézier points that enclose each curve: no
/// less than its exact extremes, and quickly known.
struct Enclosure {
  Eigen::ArrayXd lowest, highest;               ///< [joints] position
  Eigen::ArrayXd velocity, acceleration, jerk;  ///< [joints] greatest magnitudes
};
/// Between samples `sample` and `sample` + 1.
void enclose(const Trajectory& trajectory, std::size_t sample, Enclosure& enclosure);

/// How far its positions lie beyond [lower, upper] at most; 0: nowhere. Exact.
double beyond(const QuinticPiece& piece, double lower, double upper);

/// Largest |value| / limit over all joints and the whole trajectory, on the quintics (velocity: of
/// the braking curves too); the sample is the one before the place, -1 for an empty trajectory.
struct LimitUse {
  double ratio = 0;
  int sample = -1, joint = -1;
};
struct LimitReport {
  LimitUse velocity, acceleration, jerk;
  double position_margin = kNotSeen;  ///< least distance to a position limit, < 0: beyond [rad]
  int margin_sample = -1, margin_joint = -1;
};
LimitReport limit_report(const RobotTable& robot, const Trajectory& trajectory);

}  // namespace morphe::math
