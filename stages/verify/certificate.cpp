#include "stages/verify/certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stages/verify/goal_errors.hpp"
#include "stages/verify/held_drift.hpp"
#include "stages/verify/posture_errors.hpp"
#include "stages/verify/smoothness.hpp"

namespace morphe::verify {
namespace {

constexpr double kClearanceTolerance_m = 1e-4, kCertificateTolerance = 1e-9;
/// Tolerance of velocity_ratio with braking curves, whose use certify and verify each find to 1e-6.
constexpr double kBrakingRatioTolerance = 3e-6;

/// Returns the error of jerk_ratio that rounding of the stored positions alone causes: the jerk
/// contains 60 times their differences, divided by the third power of the step.
double jerk_rounding(const RobotModel& robot, const Trajectory& trajectory) {
  const std::vector<double>& time = trajectory.time;
  double step_s = time.back();
  for (int i = 1; i < std::ssize(time); ++i) step_s = std::min(step_s, time[i] - time[i - 1]);
  return 60 * std::numeric_limits<double>::epsilon() * trajectory.position.cwiseAbs().maxCoeff() /
         (std::pow(step_s, 3) * robot.jerk.minCoeff());
}

/// Returns the mean of metric A over the mapped frames that have it.
double mapped_humanlikeness(const JointRows& humanlikeness) {
  double sum = 0, count = 0;
  for (Eigen::Index f = 0; humanlikeness.cols() > 0 && f < humanlikeness.rows(); ++f) {
    if (std::isnan(humanlikeness(f, 0))) continue;
    sum += humanlikeness(f, 0);
    ++count;
  }
  return count > 0 ? sum / count : kUnknown;
}

bool agree(double stored, double recomputed, double tolerance) {
  return stored == recomputed || (std::isnan(stored) && std::isnan(recomputed)) ||
         std::abs(stored - recomputed) <= tolerance;
}

/// A value of the certificate and its name in a file.
struct Attribute {
  const char* name;
  double Certificate::*value;
};
constexpr Attribute kAttributes[] = {
    {"joint_limit_margin", &Certificate::joint_limit_margin},
    {"velocity_ratio", &Certificate::velocity_ratio},
    {"acceleration_ratio", &Certificate::acceleration_ratio},
    {"jerk_ratio", &Certificate::jerk_ratio},
    {"clearance", &Certificate::clearance},
    {"tip_error_max", &Certificate::tip_error_max},
    {"tip_error_mean", &Certificate::tip_error_mean},
    {"tip_error_grasp", &Certificate::tip_error_grasp},
    {"tip_orientation_error_max", &Certificate::tip_orientation_error_max},
    {"upper_arm_error_mean", &Certificate::upper_arm_error_mean},
    {"upper_arm_error_max", &Certificate::upper_arm_error_max},
    {"forearm_error_mean", &Certificate::forearm_error_mean},
    {"forearm_error_max", &Certificate::forearm_error_max},
    {"swivel_error_mean", &Certificate::swivel_error_mean},
    {"swivel_error_max", &Certificate::swivel_error_max},
    {"palm_error_mean", &Certificate::palm_error_mean},
    {"palm_error_max", &Certificate::palm_error_max},
    {"wrist_speed_correlation", &Certificate::wrist_speed_correlation},
    {"held_drift", &Certificate::held_drift},
    {"held_turn", &Certificate::held_turn},
    {"duration_ratio", &Certificate::duration_ratio},
    {"humanlikeness_mapped", &Certificate::humanlikeness_mapped},
    {"humanlikeness_final", &Certificate::humanlikeness_final},
    {"sparc_robot", &Certificate::sparc_robot},
    {"sparc_human", &Certificate::sparc_human},
    {"log_dimensionless_jerk_robot", &Certificate::log_dimensionless_jerk_robot},
    {"log_dimensionless_jerk_human", &Certificate::log_dimensionless_jerk_human},
};

const KindClearance* clearance_of(const Certificate& certificate, ClearanceKind kind) {
  const auto found = std::ranges::find(certificate.clearance_by_kind, kind, &KindClearance::kind);
  return found == certificate.clearance_by_kind.end() ? nullptr : &*found;
}

/// Records the clearances by kind that disagree, are missing, or appear twice. A certificate
/// without any is that of an earlier version; verify_requirements() demands them.
void verify_kinds(const Certificate& stored, const Certificate& own, ViolationLog& violations) {
  if (stored.clearance_by_kind.empty()) return;
  for (std::size_t k = 0; k < enum_count<ClearanceKind>(); ++k) {
    const auto kind = static_cast<ClearanceKind>(k);
    const KindClearance *theirs = clearance_of(stored, kind), *ours = clearance_of(own, kind);
    const double value = theirs ? theirs->clearance : kUnknown,
                 expected = ours ? ours->clearance : kUnknown;
    if (!agree(value, expected, kClearanceTolerance_m))
      violations.note_plan("certificate", fmt::format("clearance_by_kind/{}", name_of(kind)), value,
                           expected);
  }
  if (stored.clearance_by_kind.size() != own.clearance_by_kind.size())
    violations.note_plan("certificate", "clearance_by_kind/kind",
                         static_cast<double>(stored.clearance_by_kind.size()),
                         static_cast<double>(own.clearance_by_kind.size()));
}

}  // namespace

Certificate recompute_certificate(const RobotModel& robot, const Plan& plan, const Curve& curve,
                                  const LimitUse& use, const ClearanceByKind& clearance) {
  Certificate own;
  own.joint_limit_margin = use.position_margin;
  own.velocity_ratio = use.velocity_ratio;
  own.acceleration_ratio = use.acceleration_ratio;
  own.jerk_ratio = use.jerk_ratio;
  // An infinite clearance means that no pair could touch and no clearance was measured.
  for (int k = 0; k < kClearanceKindCount; ++k) {
    if (std::isinf(clearance[k])) continue;
    own.clearance_by_kind.push_back(
        {static_cast<ClearanceKind>(k), clearance[k], "", "", kUnknown});
    own.clearance = std::fmin(own.clearance, clearance[k]);
  }
  const GoalErrors goals = goal_errors(robot, plan);
  own.tip_error_max = goals.position_max;
  own.tip_error_mean = goals.position_mean;
  own.tip_error_grasp = goals.position_grasp;
  own.tip_orientation_error_max = goals.orientation_max;
  own.upper_arm_error_max = goals.upper_arm_max;
  own.upper_arm_error_mean = goals.upper_arm_mean;
  own.humanlikeness_final = goals.humanlikeness;
  own.humanlikeness_mapped = mapped_humanlikeness(plan.mapped.humanlikeness);
  const std::vector<double>& clock = plan.trajectory.demonstration_time;
  if (clock.back() > clock.front())
    own.duration_ratio = plan.trajectory.time.back() / (clock.back() - clock.front());
  recompute_posture(robot, plan, curve, own);
  recompute_held_drift(robot, plan, own);
  const Speeds speeds = mean_speeds(robot, plan.goals, curve);
  own.sparc_robot = sparc(speeds.robot, speeds.step_s);
  own.sparc_human = sparc(speeds.human, speeds.step_s);
  own.log_dimensionless_jerk_robot = log_dimensionless_jerk(speeds.robot, speeds.step_s);
  own.log_dimensionless_jerk_human = log_dimensionless_jerk(speeds.human, speeds.step_s);
  return own;
}

void verify_certificate(const RobotModel& robot, const Plan& plan, const Curve& curve,
                        const LimitUse& use, const ClearanceByKind& clearance,
                        ViolationLog& violations) {
  const Certificate own = recompute_certificate(robot, plan, curve, use, clearance);
  const Certificate& stored = plan.certificate;
  for (const auto& [name, value] : kAttributes) {
    double relative_tolerance = kCertificateTolerance;
    if (value == &Certificate::velocity_ratio && !robot.braking_curves.empty())
      relative_tolerance = kBrakingRatioTolerance;
    double tolerance = relative_tolerance * std::max(1.0, std::abs(own.*value));
    if (value == &Certificate::clearance) tolerance = kClearanceTolerance_m;
    if (value == &Certificate::jerk_ratio) tolerance += jerk_rounding(robot, plan.trajectory);
    if (!agree(stored.*value, own.*value, tolerance))
      violations.note_plan("certificate", name, stored.*value, own.*value);
  }
  verify_kinds(stored, own, violations);
  if (stored.unchecked_links != robot.unchecked_links)
    violations.note_plan("certificate", "unchecked_links",
                         static_cast<double>(stored.unchecked_links.size()),
                         static_cast<double>(robot.unchecked_links.size()));
  const bool repaired = std::ranges::any_of(
      plan.path.origin, [](SampleOrigin origin) { return origin != SampleOrigin::mapped; });
  if (plan.repaired != repaired)
    violations.note_plan("certificate", "repaired", plan.repaired, repaired);
}

void verify_no_certificate(const Plan& plan, ViolationLog& violations) {
  const Certificate& certificate = plan.certificate;
  for (const auto& [name, value] : kAttributes)
    if (!std::isnan(certificate.*value))
      violations.note_plan("certificate", name, certificate.*value, kUnknown);
  for (const KindClearance& each : certificate.clearance_by_kind)
    violations.note_plan("certificate", fmt::format("clearance_by_kind/{}", name_of(each.kind)),
                         each.clearance, kUnknown);
  const auto require_none = [&](const char* name, std::size_t count) {
    if (count > 0) violations.note_plan("structure", name, static_cast<double>(count), 0);
  };
  require_none("certificate/unchecked_links", certificate.unchecked_links.size());
  require_none("approach", plan.approach.samples());
  require_none("retreat", plan.retreat.samples());
  require_none("grasp", plan.grasp.sample >= 0 ? 1 : 0);
}

}  // namespace morphe::verify
