#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

constexpr double kReportTolerance = 1e-3;  ///< smaller changes are rounding and not noted
/// Velocity that the braking curve must allow at the ends of the range, relative to the velocity
/// limit, so that a joint can arrive there.
constexpr double kMinEndVelocityRatio = 0.05;

void tighten_position_limits(Assembly& assembly, int joint, double min_position,
                             double max_position, const std::string& cause) {
  JointLimits& limits = assembly.limits[joint];
  const JointLimits before = limits;
  const double lower = std::max(before.lower, min_position),
               upper = std::min(before.upper, max_position);
  const std::string& name = assembly.table.joint_names[joint];
  if (!(lower <= upper)) {
    return assembly.problems.add(
        fmt::format("{}: joint {}: {} excludes every position within its limits [{:.4g}, {:.4g}]; "
                    "`urdf.limits: [{{joint, enforce_position_limits: false}}]` ignores position "
                    "limits of coupled joints",
                    assembly.files.front().string(), name, cause, before.lower, before.upper));
  }
  limits.lower = lower;
  limits.upper = upper;
  if (std::max(lower - before.lower, before.upper - upper) <= kReportTolerance) return;
  assembly.notes.push_back(
      fmt::format("joint {}: {} reduces its limits to [{:.4g}, {:.4g}] from [{:.4g}, {:.4g}]", name,
                  cause, lower, upper, before.lower, before.upper));
}

void tighten_rate_limit(Assembly& assembly, int joint, double limit, double JointLimits::*member,
                        const char* kind, const std::string& cause) {
  double& value = assembly.limits[joint].*member;
  if (limit >= value) return;
  if (limit < value * (1 - kReportTolerance)) {
    assembly.notes.push_back(fmt::format("joint {}: {} reduces its {} limit to {:.4g} from {:.4g}",
                                         assembly.table.joint_names[joint], cause, kind, limit,
                                         value));
  }
  value = limit;
}

void tighten_by_coupling(Assembly& assembly, const RobotModel::CoupledLimit& limit) {
  const RobotModel::Frame& frame = assembly.table.frames[limit.frame];
  const std::string cause = fmt::format("{}, which is coupled to it,", frame.name);
  const auto joint_value = [&](double value) { return (value - frame.offset) / frame.ratio; };
  const double a = joint_value(limit.lower), b = joint_value(limit.upper);
  tighten_position_limits(assembly, frame.joint, std::min(a, b), std::max(a, b), cause);
  const double ratio = std::abs(frame.ratio);
  const auto tighten = [&](double rate, double JointLimits::*member, const char* kind) {
    tighten_rate_limit(assembly, frame.joint, rate / ratio, member, kind, cause);
  };
  tighten(limit.velocity, &JointLimits::velocity, "velocity");
  tighten(limit.acceleration, &JointLimits::acceleration, "acceleration");
  tighten(limit.jerk, &JointLimits::jerk, "jerk");
}

void tighten_by_braking(Assembly& assembly, const RobotModel::BrakingCurve& curve) {
  const double velocity = kMinEndVelocityRatio * assembly.limits[curve.joint].velocity;
  const double distance = (velocity + curve.velocity_offset) * (velocity + curve.velocity_offset) /
                          curve.twice_deceleration;
  tighten_position_limits(assembly, curve.joint, curve.lower_end + distance,
                          curve.upper_end - distance, "its braking curve");
}

}  // namespace

void tighten_limits(Assembly& assembly) {
  for (const auto& limit : assembly.table.coupled_limits) tighten_by_coupling(assembly, limit);
  for (const auto& curve : assembly.table.braking_curves) tighten_by_braking(assembly, curve);
}

}  // namespace morphe::robot
