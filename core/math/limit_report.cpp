#include "core/math/limit_report.hpp"

#include <algorithm>

#include "core/math/braking.hpp"

namespace morphe::math {
namespace {

void update_use(LimitUse& use, double ratio, int sample, int joint) {
  // NaN counts as larger than the ratio so far.
  if (use.sample >= 0 && ratio <= use.ratio) return;
  use = {ratio, sample, joint};
}

void update_use(LimitUse& use, const Range& range, double limit, int sample, int joint) {
  update_use(use, std::max(-range.least, range.greatest) / limit, sample, joint);
}

/// Updates the use of the velocity limits of a joint, also those of braking curves.
void update_velocity_use(LimitUse& use, const RobotModel& robot, const QuinticPiece& piece,
                         const Range& velocity, int sample, int joint) {
  update_use(use, velocity, robot.velocity[joint], sample, joint);
  for (const RobotModel::BrakingCurve& curve : robot.braking_curves)
    if (curve.joint == joint)
      update_use(use, braking_ratio(curve, piece, use.ratio), sample, joint);
}

}  // namespace

LimitReport limit_report(const RobotModel& robot, const Trajectory& trajectory) {
  LimitReport report;
  Enclosure bounds;
  const auto covers = [](const LimitUse& use, double value, double limit) {
    return use.sample >= 0 && value <= use.ratio * limit;
  };
  for (int sample = 0; sample + 1 < std::ssize(trajectory.time); ++sample) {
    enclose(trajectory, sample, bounds);
    for (int joint = 0; joint < trajectory.position.cols(); ++joint) {
      const double min_margin = std::min(bounds.lowest[joint] - robot.lower[joint],
                                         robot.upper[joint] - bounds.highest[joint]);
      if (report.margin_sample >= 0 && min_margin >= report.position_margin &&
          covers(report.velocity, bounds.velocity[joint], robot.velocity[joint]) &&
          covers(report.acceleration, bounds.acceleration[joint], robot.acceleration[joint]) &&
          covers(report.jerk, bounds.jerk[joint], robot.jerk[joint]) &&
          std::ranges::find(robot.braking_curves, joint, &RobotModel::BrakingCurve::joint) ==
              robot.braking_curves.end())
        continue;  // no bound of this joint exceeds the maxima so far
      const QuinticPiece piece = quintic_piece(trajectory, sample, joint);
      const QuinticExtremes over = extremes(piece);
      update_velocity_use(report.velocity, robot, piece, over.velocity, sample, joint);
      update_use(report.acceleration, over.acceleration, robot.acceleration[joint], sample, joint);
      update_use(report.jerk, over.jerk, robot.jerk[joint], sample, joint);
      const double margin = std::min(over.position.least - robot.lower[joint],
                                     robot.upper[joint] - over.position.greatest);
      if (report.margin_sample >= 0 && margin >= report.position_margin) continue;
      report.position_margin = margin;
      report.margin_sample = sample;
      report.margin_joint = joint;
    }
  }
  return report;
}

CubicLimitReport cubic_limit_report(const RobotModel& robot, const Trajectory& trajectory) {
  CubicLimitReport report;
  for (int sample = 0; sample + 1 < std::ssize(trajectory.time); ++sample) {
    for (int joint = 0; joint < trajectory.position.cols(); ++joint) {
      const QuinticPiece piece = cubic_piece(trajectory, sample, joint);
      const QuinticExtremes over = extremes(piece);
      update_velocity_use(report.velocity, robot, piece, over.velocity, sample, joint);
      update_use(report.acceleration, over.acceleration, robot.acceleration[joint], sample, joint);
    }
  }
  return report;
}

}  // namespace morphe::math
