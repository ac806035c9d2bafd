#include "stages/verify/curve.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {

double Curve::time_at(std::size_t piece, double s) const {
  return std::lerp(trajectory->time[piece], trajectory->time[piece + 1], s);
}

double Curve::demonstration_time_at(std::size_t piece, double s) const {
  return std::lerp(trajectory->demonstration_time[piece], trajectory->demonstration_time[piece + 1],
                   s);
}

void Curve::position_at(std::size_t piece, double s, JointVector& q) const {
  q.resize(joints);
  for (std::size_t j = 0; j < joints; ++j) {
    q(j) = derivative(quintics[piece * joints + j], 0, s);
  }
}

Curve make_curve(const Trajectory& trajectory) {
  Curve curve;
  curve.trajectory = &trajectory;
  curve.joints = trajectory.position.cols();
  curve.pieces = trajectory.samples() - 1;
  curve.speed.resize(curve.pieces, trajectory.position.cols());
  curve.quintics.reserve(curve.pieces * curve.joints);
  curve.ranges.reserve(curve.pieces * curve.joints);
  const auto state = [&](Eigen::Index sample, Eigen::Index joint) {
    return JointState{trajectory.position(sample, joint), trajectory.velocity(sample, joint),
                      trajectory.acceleration(sample, joint)};
  };
  for (Eigen::Index i = 0; i < curve.speed.rows(); ++i) {
    const auto piece = static_cast<std::size_t>(i);
    const double step_s = trajectory.time[piece + 1] - trajectory.time[piece];
    for (Eigen::Index j = 0; j < curve.speed.cols(); ++j) {
      curve.quintics.push_back(quintic_between(step_s, state(i, j), state(i + 1, j)));
      curve.ranges.push_back(ranges(curve.quintics.back()));
      const Range& velocity = curve.ranges.back()[1];
      curve.speed(i, j) = std::max(-velocity.least.value, velocity.greatest.value);
    }
  }
  return curve;
}

}  // namespace morphe::verify
