#include "stages/verify/limits.hpp"

#include "stages/verify/braking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphe::verify {
namespace {

constexpr double kRelativeTolerance = 1e-6;
constexpr double kRestTolerance = 1e-9;
constexpr const char* kCauses[] = {"position", "velocity", "acceleration", "jerk"};

CurvePoint place_of(const Curve& curve, std::size_t piece, double s) {
  return {static_cast<int>(2 * piece + 1), static_cast<int>(s < 0.5 ? piece : piece + 1),
          curve.time_at(piece, s)};
}

/// Checks the coupled frames' own limits: a coupled frame's value is ratio * q + offset, and so are
/// its extrema.
void verify_coupled_limits(const RobotModel& robot, const Curve& curve, std::size_t piece,
                           ViolationCollector& runs) {
  for (const RobotModel::CoupledLimit& own : robot.coupled_limits) {
    const RobotModel::Frame& frame = robot.frames[own.frame];
    const auto& ranges = curve.ranges[piece * curve.joints + frame.joint];
    for (const Extreme& end : {ranges[0].least, ranges[0].greatest}) {
      const double value = frame.ratio * end.value + frame.offset;
      const double beyond = std::max(own.lower - value, value - own.upper);
      if (!(beyond <= kRelativeTolerance * std::max(1.0, std::abs(value))))
        runs.note("position", frame.name, place_of(curve, piece, end.s), value,
                  value < own.lower ? own.lower : own.upper, beyond);
    }
    const double limits[] = {own.velocity, own.acceleration, own.jerk};
    for (std::size_t order = 1; order < 4; ++order) {
      const double limit = limits[order - 1];
      for (const Extreme& end : {ranges[order].least, ranges[order].greatest}) {
        const double value = std::abs(frame.ratio * end.value);
        if (!(value <= limit * (1 + kRelativeTolerance)))
          runs.note(kCauses[order], frame.name, place_of(curve, piece, end.s), value, limit,
                    value / limit);
      }
    }
  }
}

void verify_braking_curves(const RobotModel& robot, const Curve& curve, std::size_t piece,
                           LimitUse& use, ViolationCollector& runs) {
  for (const RobotModel::BrakingCurve& braking : robot.braking_curves) {
    const auto joint = static_cast<std::size_t>(braking.joint);
    const Quintic& quintic = curve.quintics[piece * curve.joints + joint];
    const double known = std::min(use.velocity_ratio, 1 + kRelativeTolerance);
    const BrakingLimitUse worst = max_braking_use(braking, quintic, known);
    use.velocity_ratio = std::max(use.velocity_ratio, worst.ratio);
    if (!(worst.ratio <= 1 + kRelativeTolerance))
      runs.note("velocity", robot.joint_names[joint], place_of(curve, piece, worst.s), worst.speed,
                worst.allowed_speed, worst.ratio);
  }
}

}  // namespace

LimitUse verify_limits(const RobotModel& robot, const Curve& curve, ViolationCollector& runs) {
  LimitUse use;
  use.position_margin = std::numeric_limits<double>::infinity();
  const JointVector* magnitudes[] = {nullptr, &robot.velocity, &robot.acceleration, &robot.jerk};
  double* ratios[] = {nullptr, &use.velocity_ratio, &use.acceleration_ratio, &use.jerk_ratio};

  for (std::size_t piece = 0; piece < curve.pieces; ++piece) {
    for (std::size_t joint = 0; joint < curve.joints; ++joint) {
      const auto j = static_cast<Eigen::Index>(joint);
      const auto& ranges = curve.ranges[piece * curve.joints + joint];
      const std::string& name = robot.joint_names[joint];

      const Range& position = ranges[0];
      const double below = position.least.value - robot.lower(j);
      const double above = robot.upper(j) - position.greatest.value;
      const double margin = std::min(below, above);
      use.position_margin = std::min(use.position_margin, margin);
      if (!(margin >= -kRelativeTolerance * (robot.upper(j) - robot.lower(j)))) {
        const Extreme& worst = below < above ? position.least : position.greatest;
        runs.note("position", name, place_of(curve, piece, worst.s), worst.value,
                  below < above ? robot.lower(j) : robot.upper(j), -margin);
      }
      for (std::size_t order = 1; order < 4; ++order) {
        const Range& range = ranges[order];
        const bool negative = -range.least.value > range.greatest.value;
        const Extreme& worst = negative ? range.least : range.greatest;
        const double limit = (*magnitudes[order])(j);
        const double ratio = std::abs(worst.value) / limit;
        *ratios[order] = std::max(*ratios[order], ratio);
        if (!(ratio <= 1 + kRelativeTolerance))
          runs.note(kCauses[order], name, place_of(curve, piece, worst.s), std::abs(worst.value),
                    limit, ratio);
      }
    }
    verify_coupled_limits(robot, curve, piece, runs);
    verify_braking_curves(robot, curve, piece, use, runs);
  }
  return use;
}

void verify_rest(const RobotModel& robot, const Trajectory& trajectory, ViolationCollector& runs) {
  const auto last = static_cast<Eigen::Index>(trajectory.samples()) - 1;
  for (const Eigen::Index sample : {Eigen::Index{0}, last}) {
    for (Eigen::Index j = 0; j < trajectory.position.cols(); ++j) {
      const double most = std::max(std::abs(trajectory.velocity(sample, j)),
                                   std::abs(trajectory.acceleration(sample, j)));
      if (most <= kRestTolerance) continue;
      const auto row = static_cast<std::size_t>(sample);
      // Both ends are reported, even for a trajectory so short that they are neighbours.
      runs.note("rest", robot.joint_names[j],
                {sample == 0 ? 0 : static_cast<int>(2 * row + 2), static_cast<int>(row),
                 trajectory.time[row]},
                most, kRestTolerance, most);
    }
  }
}

}  // namespace morphe::verify
