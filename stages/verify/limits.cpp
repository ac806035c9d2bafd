#include "stages/verify/limits.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/braking.hpp"

namespace morphe::verify {
namespace {

constexpr double kRelativeTolerance = 1e-6;
constexpr double kRestTolerance = 1e-9;
constexpr const char* kCauses[] = {"position", "velocity", "acceleration", "jerk"};

/// Checks the limits of coupled frames. Their values ratio * q + offset are extreme where q is.
void verify_coupled_limits(const RobotModel& robot, const Curve& curve, int piece,
                           ViolationLog& violations) {
  for (const RobotModel::CoupledLimit& coupled : robot.coupled_limits) {
    const RobotModel::Frame& frame = robot.frames[coupled.frame];
    const std::array<Range, 4>& ranges = curve.ranges[piece * curve.joints + frame.joint];
    for (const Extreme& extreme : {ranges[0].least, ranges[0].greatest}) {
      const double value = frame.ratio * extreme.value + frame.offset;
      const double excess = std::max(coupled.lower - value, value - coupled.upper);
      if (!(excess <= kRelativeTolerance * std::max(1.0, std::abs(value))))
        violations.note("position", frame.name, curve.point_at(piece, extreme.s), value,
                        value < coupled.lower ? coupled.lower : coupled.upper, excess);
    }
    const double limits[] = {kInfinity, coupled.velocity, coupled.acceleration, coupled.jerk};
    for (int order = 1; order < 4; ++order) {
      for (const Extreme& extreme : {ranges[order].least, ranges[order].greatest}) {
        const double value = std::abs(frame.ratio * extreme.value);
        if (!(value <= limits[order] * (1 + kRelativeTolerance)))
          violations.note(kCauses[order], frame.name, curve.point_at(piece, extreme.s), value,
                          limits[order], value / limits[order]);
      }
    }
  }
}

void verify_braking_curves(const RobotModel& robot, const Curve& curve, int piece, LimitUse& use,
                           ViolationLog& violations) {
  for (const RobotModel::BrakingCurve& braking : robot.braking_curves) {
    const double known_ratio = std::min(use.velocity_ratio, 1 + kRelativeTolerance);
    const BrakingLimitUse worst =
        max_braking_use(braking, curve.quintics[piece * curve.joints + braking.joint], known_ratio);
    use.velocity_ratio = std::max(use.velocity_ratio, worst.ratio);
    if (!(worst.ratio <= 1 + kRelativeTolerance))
      violations.note("velocity", robot.joint_names[braking.joint], curve.point_at(piece, worst.s),
                      worst.speed, worst.allowed_speed, worst.ratio);
  }
}

}  // namespace

LimitUse verify_limits(const RobotModel& robot, const Curve& curve, ViolationLog& violations) {
  LimitUse use;
  use.position_margin = kInfinity;
  const JointVector* limits[] = {nullptr, &robot.velocity, &robot.acceleration, &robot.jerk};
  double* ratios[] = {nullptr, &use.velocity_ratio, &use.acceleration_ratio, &use.jerk_ratio};

  for (int piece = 0; piece < curve.pieces; ++piece) {
    for (Eigen::Index j = 0; j < curve.joints; ++j) {
      const std::array<Range, 4>& ranges = curve.ranges[piece * curve.joints + j];
      const std::string& name = robot.joint_names[j];

      const Range& position = ranges[0];
      const double below = position.least.value - robot.lower(j);
      const double above = robot.upper(j) - position.greatest.value;
      const double margin = std::min(below, above);
      use.position_margin = std::min(use.position_margin, margin);
      if (!(margin >= -kRelativeTolerance * (robot.upper(j) - robot.lower(j)))) {
        const Extreme& worst = below < above ? position.least : position.greatest;
        violations.note("position", name, curve.point_at(piece, worst.s), worst.value,
                        below < above ? robot.lower(j) : robot.upper(j), -margin);
      }
      for (int order = 1; order < 4; ++order) {
        const Range& range = ranges[order];
        const bool negative = -range.least.value > range.greatest.value;
        const Extreme& worst = negative ? range.least : range.greatest;
        const double limit = (*limits[order])(j);
        const double ratio = std::abs(worst.value) / limit;
        *ratios[order] = std::max(*ratios[order], ratio);
        if (!(ratio <= 1 + kRelativeTolerance))
          violations.note(kCauses[order], name, curve.point_at(piece, worst.s),
                          std::abs(worst.value), limit, ratio);
      }
    }
    verify_coupled_limits(robot, curve, piece, violations);
    verify_braking_curves(robot, curve, piece, use, violations);
  }
  return use;
}

void verify_rest(const RobotModel& robot, const Curve& curve, ViolationLog& violations) {
  const Trajectory& trajectory = *curve.trajectory;
  for (const int sample : {0, curve.pieces}) {
    CurvePoint point = point_at_sample(trajectory, sample);
    // Both ends are reported, even for a trajectory so short that they are neighbours.
    if (sample > 0) point.step += 2;
    for (Eigen::Index j = 0; j < trajectory.position.cols(); ++j) {
      const double largest = std::max(std::abs(trajectory.velocity(sample, j)),
                                      std::abs(trajectory.acceleration(sample, j)));
      if (largest <= kRestTolerance) continue;
      violations.note("rest", robot.joint_names[j], point, largest, kRestTolerance, largest);
    }
  }
}

}  // namespace morphe::verify
