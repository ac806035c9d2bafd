#include "pipeline/verify/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphe::verify {
namespace {

constexpr double kRelativeTolerance = 1e-6;
constexpr double kRestTolerance = 1e-9;

CurvePoint place_of(const Curve& curve, std::size_t piece, double s) {
  return {static_cast<int>(2 * piece + 1), static_cast<int>(s < 0.5 ? piece : piece + 1),
          curve.time_at(piece, s)};
}

}  // namespace

LimitUse judge_limits(const RobotTable& robot, const Curve& curve, ViolationRuns& runs) {
  LimitUse use;
  use.position_margin = std::numeric_limits<double>::infinity();
  constexpr const char* kCauses[] = {"position", "velocity", "acceleration", "jerk"};
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
  }
  return use;
}

void judge_rest(const RobotTable& robot, const Trajectory& trajectory, ViolationRuns& runs) {
  const auto last = static_cast<Eigen::Index>(trajectory.samples()) - 1;
  for (const Eigen::Index sample : {Eigen::Index{0}, last}) {
    for (Eigen::Index j = 0; j < trajectory.position.cols(); ++j) {
      const double most = std::max(std::abs(trajectory.velocity(sample, j)),
                                   std::abs(trajectory.acceleration(sample, j)));
      if (most <= kRestTolerance) continue;
      const auto row = static_cast<std::size_t>(sample);
      // Both ends are told even of a trajectory so short that they are neighbours.
      runs.note("rest", robot.joint_names[static_cast<std::size_t>(j)],
                {sample == 0 ? 0 : static_cast<int>(2 * row + 2), static_cast<int>(row),
                 trajectory.time[row]},
                most, kRestTolerance, most);
    }
  }
}

}  // namespace morphe::verify
