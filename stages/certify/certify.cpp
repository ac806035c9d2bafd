#include "stages/certify/certify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/collision/continuous_check.hpp"
#include "core/math/limit_report.hpp"
#include "core/math/statistics.hpp"
#include "core/motion/finding_text.hpp"
#include "core/robot/joint_unit.hpp"
#include "stages/certify/goal_errors.hpp"
#include "stages/certify/posture_errors.hpp"
#include "stages/certify/smoothness.hpp"
#include "stages/certify/trajectory_motion.hpp"
#include "stages/certify/wrist_speed.hpp"

namespace morphe::certify {
namespace {

constexpr double kClearanceResolution_m = 1e-5;  ///< of the clearance over the whole motion
/// Travel down to which a motion is bisected that the usual kMotionBand_m leaves undecided; it must
/// be above the 1e-5 m of stages/verify, which has to prove the same.
constexpr double kFineBand_m = 2e-5;

std::string limit_violation(const RobotModel& robot, const Trajectory& trajectory,
                            const math::LimitReport& report) {
  const auto sentence = [&](const char* quantity, int sample, int joint, const std::string& value) {
    return fmt::format("{} of joint {} is {} after sample {} ({:.3f} s)", quantity,
                       robot.joint_names[joint], value, sample, trajectory.time[sample]);
  };
  if (!(report.position_margin >= 0)) {
    return sentence(
        "position", report.margin_sample, report.margin_joint,
        amount_text(-report.position_margin, robot::joint_unit(robot, report.margin_joint)) +
            " beyond its limit");
  }
  const auto excess_of = [&](const char* quantity, const math::LimitUse& use) {
    return use.ratio <= 1 ? std::string()
                          : sentence(quantity, use.sample, use.joint,
                                     fmt::format("{:.4f} times its limit", use.ratio));
  };
  for (const std::string& found :
       {excess_of("velocity", report.velocity), excess_of("acceleration", report.acceleration),
        excess_of("jerk", report.jerk)}) {
    if (!found.empty()) return found;
  }
  return "";
}

double nan_if_infinite(double clearance) { return std::isinf(clearance) ? kUnknown : clearance; }

/// Sets the clearance of a motion, over all pairs and of each kind.
void set_clearance(const collision::CollisionWorld& world, const collision::JointMotion& motion,
                   collision::CollisionScratch& scratch, Certificate& certificate) {
  const auto kinds = collision::clearance_by_kind(world, motion, scratch, kClearanceResolution_m);
  double least_m = kInfinity;
  for (int k = 0; k < kClearanceKindCount; ++k) {
    const collision::MotionClearance& found = kinds[k];
    if (!std::isfinite(found.distance)) continue;
    least_m = std::min(least_m, found.lower_bound_m);
    certificate.clearance_by_kind.push_back({static_cast<ClearanceKind>(k), found.lower_bound_m,
                                             collision::first_body_name(world, found.pair),
                                             collision::second_body_name(world, found.pair),
                                             found.parameter});
  }
  certificate.clearance = nan_if_infinite(least_m);
}

/// Returns a sentence about a contact that is not allowed or cannot be excluded, or "".
std::string collision_violation(const collision::CollisionWorld& world,
                                const collision::JointMotion& motion, const Trajectory& trajectory,
                                collision::CollisionScratch& scratch) {
  collision::MotionCheck found = collision::check_motion(world, motion, scratch);
  if (found.verdict == collision::MotionVerdict::undecided)
    found = collision::check_motion(world, motion, scratch, kFineBand_m);
  if (found.verdict == collision::MotionVerdict::free) return "";
  return fmt::format(
      "{} and {} are {:.2f} mm apart at {:.3f} s (sample {}), {} than the {:.2f} mm required",
      collision::first_body_name(world, found.pair), collision::second_body_name(world, found.pair),
      1e3 * found.pair.separation.distance, found.parameter,
      sample_before(trajectory, found.parameter),
      found.verdict == collision::MotionVerdict::colliding ? "less" : "not provably more",
      1e3 * found.pair.required_distance_m);
}

/// Returns a sentence if the hand lets go of the target in the air at the end of a transport, or
/// "".
std::string release_violation(const collision::CollisionWorld& world, const Movement& movement) {
  const double gap_m = world.carried.release_gap_m;
  if (gap_m <= collision::kMaxReleaseGap_m || !last_phase(movement, PhaseKind::transport))
    return "";
  const SceneObject& target = world.scene->objects[world.target];
  return fmt::format(
      "{} is released at {:.2f} s, {:.1f} mm or more from everything that could support it; "
      "allowed: {:.1f} mm",
      target.name, target.release_s, 1e3 * gap_m, 1e3 * collision::kMaxReleaseGap_m);
}

std::string tracking_violation(const RobotModel& robot, const Trajectory& trajectory,
                               const GoalErrors& errors) {
  if (errors.worst_sample < 0 || errors.worst_excess <= 0) return "";
  return fmt::format("{} is {:.2f} mm from its goal at sample {} ({:.3f} s); allowed: {:.2f} mm",
                     robot.tips[errors.worst_tip].name, 1e3 * errors.worst_error,
                     errors.worst_sample, trajectory.time[errors.worst_sample],
                     1e3 * errors.worst_tolerance);
}

std::string tracking_violation(const RobotModel& robot, const InterSampleTipError& between) {
  if (!(between.excess > 0)) return "";
  return fmt::format("{} is {:.2f} mm from its goal after sample {} ({:.3f} s); allowed: {:.2f} mm",
                     robot.tips[between.tip].name, 1e3 * between.error, between.sample,
                     between.time_s, 1e3 * between.tolerance);
}

}  // namespace

Outcome<Certificate> certify_motion(const collision::CollisionWorld& world,
                                    Trajectory& trajectory) {
  Outcome<Certificate> result;
  const auto fail = [&](Reason reason, const std::string& sentence) {
    if (!result.failure && !sentence.empty()) result.failure = {reason, sentence};
  };
  if (trajectory.samples() < 2) {
    fail(Reason::invalid_path, "the trajectory has fewer than two samples");
    return result;
  }
  Certificate& c = result.value;
  const math::LimitReport limits = math::limit_report(*world.robot, trajectory);
  c.joint_limit_margin = limits.position_margin;
  c.velocity_ratio = limits.velocity.ratio;
  c.acceleration_ratio = limits.acceleration.ratio;
  c.jerk_ratio = limits.jerk.ratio;
  fail(Reason::joint_limit, limit_violation(*world.robot, trajectory, limits));

  collision::CollisionScratch scratch;
  trajectory.clearance.resize(trajectory.samples());
  for (int i = 0; i < std::ssize(trajectory.time); ++i) {
    const JointVector q = trajectory.position.row(i).transpose();
    trajectory.clearance[i] =
        nan_if_infinite(collision::clearance(world, q, trajectory.demonstration_time[i], scratch));
  }
  const collision::JointMotion motion = trajectory_motion(trajectory);
  set_clearance(world, motion, scratch, c);
  c.unchecked_links = world.robot->unchecked_links;
  fail(Reason::smoothing_collision, collision_violation(world, motion, trajectory, scratch));
  return result;
}

Outcome<Certificate> certify(const collision::CollisionWorld& recorded_world, const Goals& goals,
                             const Movement& movement, Trajectory& trajectory,
                             const MappingResult& mapped) {
  collision::CollisionWorld world = recorded_world;
  collision::attach_target(trajectory.demonstration_time, trajectory.position, world);
  Outcome<Certificate> result = certify_motion(world, trajectory);
  if (trajectory.samples() < 2) return result;
  Certificate& c = result.value;
  const GoalErrors errors =
      goal_errors(*world.robot, goals, movement, world.tolerances, trajectory);
  c.tip_error_max = errors.position_max;
  c.tip_error_mean = errors.position_mean;
  c.tip_error_grasp = errors.position_grasp;
  c.tip_orientation_error_max = errors.orientation_max;
  c.upper_arm_error_max = errors.upper_arm_max;
  c.upper_arm_error_mean = errors.upper_arm_mean;
  set_posture_errors(*world.robot, goals, trajectory, c);
  c.wrist_speed_correlation = wrist_speed_correlation(*world.robot, goals, trajectory);
  std::string violation = tracking_violation(*world.robot, trajectory, errors);
  if (violation.empty()) {
    violation = tracking_violation(
        *world.robot,
        worst_inter_sample_error(*world.robot, goals, movement, world.tolerances, trajectory));
  }
  if (!result.failure && !violation.empty()) result.failure = {Reason::tracking, violation};
  violation = release_violation(world, movement);
  if (!result.failure && !violation.empty()) result.failure = {Reason::released_in_air, violation};

  const std::vector<double>& times = trajectory.demonstration_time;
  const double human_s = times.back() - times.front();
  if (human_s > 0) c.duration_ratio = trajectory.time.back() / human_s;
  if (mapped.humanlikeness.cols() > 0) {
    const auto& sums = mapped.humanlikeness.col(0);
    c.humanlikeness_mapped = math::mean({sums.begin(), sums.end()});
  }
  c.humanlikeness_final = errors.humanlikeness;
  const SpeedProfile robot = robot_speed(*world.robot, goals, trajectory);
  const SpeedProfile human = human_speed(goals);
  c.sparc_robot = spectral_arc_length(robot);
  c.sparc_human = spectral_arc_length(human);
  c.log_dimensionless_jerk_robot = log_dimensionless_jerk(robot);
  c.log_dimensionless_jerk_human = log_dimensionless_jerk(human);
  return result;
}

}  // namespace morphe::certify
