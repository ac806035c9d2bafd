#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

constexpr double kReportTolerance = 1e-3;  ///< smaller changes are rounding in the file
/// Smallest share of the velocity limit at the ends of the range; below it, a joint would hardly
/// arrive there.
constexpr double kMinEndVelocityRatio = 0.05;

struct Bounds {
  double lower, upper;
};

void tighten_position_limits(Assembly& assembly, int joint, const Bounds& bounds,
                             const std::string& by) {
  const auto j = static_cast<std::size_t>(joint);
  const Bounds before{assembly.lower[j], assembly.upper[j]};
  const double lower = std::max(before.lower, bounds.lower);
  const double upper = std::min(before.upper, bounds.upper);
  const std::string& name = assembly.table.joint_names[j];
  if (!(lower <= upper)) {
    return assembly.problems.add(
        fmt::format("{}: joint {}: {} excludes every position within its limits [{:.4g}, {:.4g}]; "
                    "`urdf.limits: [{{joint, enforce_position_limits: false}}]` ignores position "
                    "limits of coupled joints",
                    assembly.files.front().string(), name, by, before.lower, before.upper));
  }
  assembly.lower[j] = lower;
  assembly.upper[j] = upper;
  if (std::max(lower - before.lower, before.upper - upper) <= kReportTolerance) return;
  assembly.notes.push_back(
      fmt::format("joint {}: {} reduces its limits to [{:.4g}, {:.4g}] from [{:.4g}, {:.4g}]", name,
                  by, lower, upper, before.lower, before.upper));
}

void tighten_rate_limit(Assembly& assembly, double most, std::vector<double>& values, int joint,
                        const char* what, const std::string& by) {
  double& value = values[joint];
  if (most >= value) return;
  if (most < value * (1 - kReportTolerance)) {
    assembly.notes.push_back(fmt::format("joint {}: {} reduces its {} limit to {:.4g} from {:.4g}",
                                         assembly.table.joint_names[joint], by, what, most, value));
  }
  value = most;
}

void tighten_by_coupling(Assembly& assembly, const RobotModel::CoupledLimit& limit) {
  const RobotModel::Frame& frame = assembly.table.frames[limit.frame];
  const std::string by = fmt::format("{}, which is coupled to it,", frame.name);
  const auto needs = [&](double value) { return (value - frame.offset) / frame.ratio; };
  const double a = needs(limit.lower), b = needs(limit.upper);
  tighten_position_limits(assembly, frame.joint, {std::min(a, b), std::max(a, b)}, by);
  const double ratio = std::abs(frame.ratio);
  tighten_rate_limit(assembly, limit.velocity / ratio, assembly.velocity, frame.joint, "velocity",
                     by);
  tighten_rate_limit(assembly, limit.acceleration / ratio, assembly.acceleration, frame.joint,
                     "acceleration", by);
  tighten_rate_limit(assembly, limit.jerk / ratio, assembly.jerk, frame.joint, "jerk", by);
}

void tighten_by_braking(Assembly& assembly, const RobotModel::BrakingCurve& curve) {
  const double left = kMinEndVelocityRatio * assembly.velocity[curve.joint];
  const double way =
      (left + curve.velocity_offset) * (left + curve.velocity_offset) / curve.twice_deceleration;
  tighten_position_limits(assembly, curve.joint, {curve.lower_end + way, curve.upper_end - way},
                          "its braking curve");
}

}  // namespace

void tighten_limits(Assembly& assembly) {
  for (const auto& limit : assembly.table.coupled_limits) tighten_by_coupling(assembly, limit);
  for (const auto& curve : assembly.table.braking_curves) tighten_by_braking(assembly, curve);
}

}  // namespace morphe::robot
