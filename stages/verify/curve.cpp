#include "stages/verify/curve.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {

CurvePoint Curve::point_at(int piece, double s) const {
  return {2 * piece + 1, s < 0.5 ? piece : piece + 1,
          std::lerp(trajectory->time[piece], trajectory->time[piece + 1], s)};
}

double Curve::demonstration_time_at(int piece, double s) const {
  const std::vector<double>& time = trajectory->demonstration_time;
  return std::lerp(time[piece], time[piece + 1], s);
}

void Curve::position_at(int piece, double s, JointVector& q) const {
  q.resize(joints);
  for (Eigen::Index j = 0; j < joints; ++j) q(j) = derivative(quintics[piece * joints + j], 0, s);
}

Curve make_curve(const Trajectory& trajectory) {
  Curve curve;
  curve.trajectory = &trajectory;
  curve.joints = trajectory.position.cols();
  curve.pieces = static_cast<int>(trajectory.samples()) - 1;
  curve.speed.resize(curve.pieces, curve.joints);
  curve.quintics.reserve(curve.pieces * curve.joints);
  curve.ranges.reserve(curve.pieces * curve.joints);
  const auto state = [&](int sample, Eigen::Index joint) {
    return JointState{trajectory.position(sample, joint), trajectory.velocity(sample, joint),
                      trajectory.acceleration(sample, joint)};
  };
  for (int piece = 0; piece < curve.pieces; ++piece) {
    const double step_s = trajectory.time[piece + 1] - trajectory.time[piece];
    for (Eigen::Index j = 0; j < curve.joints; ++j) {
      curve.quintics.push_back(quintic_between(step_s, state(piece, j), state(piece + 1, j)));
      curve.ranges.push_back(ranges(curve.quintics.back()));
      const Range& velocity = curve.ranges.back()[1];
      curve.speed(piece, j) = std::max(-velocity.least.value, velocity.greatest.value);
    }
  }
  return curve;
}

CurvePoint point_at_sample(const Trajectory& trajectory, int sample) {
  return {2 * sample, sample, trajectory.time[sample]};
}

}  // namespace morphe::verify
