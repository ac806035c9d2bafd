#include "pipeline/planning/approach.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/seed.hpp"
#include "pipeline/planning/planner.hpp"
#include "stages/certify/certify.hpp"
#include "stages/repair/repair_strategy.hpp"
#include "stages/repair/transit.hpp"

namespace morphe::planning {
namespace {

/// Tolerance between an end of the motion and the adjacent motion or the home posture [rad, m].
constexpr double kEndTolerance = 1e-6;

double end_error(const JointPath& path, const Trajectory& trajectory) {
  const auto off = [](const auto& own, const auto& asked) {
    return (own - asked).cwiseAbs().maxCoeff();
  };
  return std::max(off(trajectory.position.topRows(1), path.position.topRows(1)),
                  off(trajectory.position.bottomRows(1), path.position.bottomRows(1)));
}

/// Computes the time parametrisation and certifies it; smoothing is disabled if it causes a
/// collision or misses an end (if a joint leaves its limit at once).
PlanningFailure time_and_certify(const PlanningInputs& planner,
                                 const collision::CollisionWorld& world, const JointPath& path,
                                 const ApproachOptions& options, double time_s,
                                 Trajectory& trajectory) {
  retime::RetimeOptions time_law = planner.config.retime;
  time_law.mode = retime::RetimeMode::fastest;
  time_law.duration_s.reset();
  time_law.phase_speed.clear();
  time_law.limit_scaling *= options.limit_scaling;
  while (true) {
    Outcome<retime::RetimeResult> retimed =
        retime::retime(planner.robot, path, Movement{}, time_law);
    if (retimed.failure) return retimed.failure;
    trajectory = std::move(retimed.value.trajectory);
    // The demonstration time stands still, so that contact is judged by that moment.
    std::ranges::fill(trajectory.demonstration_time, time_s);
    std::ranges::fill(trajectory.phase, PhaseKind::rest);
    PlanningFailure failure = certify::certify_motion(world, trajectory).failure;
    if (const double off = end_error(path, trajectory); !failure && !(off <= kEndTolerance))
      failure = {Reason::smoothing_collision,
                 fmt::format("the smoothed curve misses an endpoint by {:.2g} rad or m", off)};
    const bool smoothed = time_law.tip_tolerance + time_law.joint_tolerance > 0;
    if (failure.reason != Reason::smoothing_collision || !smoothed) return failure;
    time_law.tip_tolerance = time_law.joint_tolerance = 0;
  }
}

std::string sentence(const PlanningFailure& failure) {
  return fmt::format("{}: {}", name_of(failure.reason), failure.detail);
}

/// Returns the reason for which there is no path between two postures.
std::string no_path_reason(const collision::CollisionWorld& world, const JointVector& from,
                           const JointVector& to, double time_s,
                           const repair::RepairOptions& repair) {
  collision::CollisionScratch scratch;
  for (const JointVector& end : {from, to}) {
    const collision::PairSeparation pair = collision::least_slack(world, end, time_s, scratch);
    if (pair.slack() >= 0) continue;
    return fmt::format(
        "{} is {:.1f} mm too close to {} at an endpoint", collision::first_body_name(world, pair),
        kMillimetresPerMetre * -pair.slack(), collision::second_body_name(world, pair));
  }
  return repair::no_path_message(repair);
}

/// Returns the plan's own motion followed by its approach, both reversed.
JointPath reverse_path(const Trajectory& trajectory, const JointPath& approach) {
  constexpr Eigen::Index kReverseSampleStride = 5;
  std::vector<JointVector> rows;
  for (Eigen::Index k = trajectory.position.rows() - 1; k > 0; k -= kReverseSampleStride) {
    rows.push_back(trajectory.position.row(k).transpose());
  }
  for (Eigen::Index k = approach.position.rows() - 1; k >= 0; --k) {
    rows.push_back(approach.position.row(k).transpose());
  }
  JointPath back;
  back.position.resize(rows.size(), trajectory.position.cols());
  back.origin.assign(rows.size(), SampleOrigin::planned);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    back.position.row(k) = rows[k].transpose();
    back.demonstration_time.push_back(0.01 * static_cast<double>(k));
  }
  return back;
}

}  // namespace

std::string validation_error(const ApproachOptions& options) {
  if (!(options.limit_scaling > 0) || !(options.limit_scaling <= 1)) {
    return "limit_scaling must be above 0 and at most 1";
  }
  return "";
}

JointVector home_posture(const RobotModel& robot, const ApproachOptions& options) {
  JointVector home = JointVector::Zero(robot.joints());
  for (const ApproachOptions::Joint& joint : options.home) {
    const auto found = std::ranges::find(robot.joint_names, joint.joint);
    home[found - robot.joint_names.begin()] = joint.value;
  }
  return home.cwiseMax(robot.lower).cwiseMin(robot.upper);
}

PlanningFailure add_approach(const PlanningInputs& planner, const ApproachOptions& options,
                             std::uint64_t seed, Plan& plan) {
  const repair::RepairOptions& repair = planner.config.repair;
  const JointVector home = home_posture(planner.robot, options);
  collision::CollisionWorld world = collision::make_world(
      planner.robot, plan.scene, plan.movement, plan.tolerances, planner.config.scene.meshes);
  collision::attach_target(plan.trajectory.demonstration_time, plan.trajectory.position, world);
  const Trajectory& way = plan.trajectory;
  const double begin_s = way.demonstration_time.front(), end_s = way.demonstration_time.back();
  const JointVector first = way.position.row(0).transpose();
  const JointVector last = way.position.row(way.position.rows() - 1).transpose();

  const JointPath there =
      repair::plan_transit(world, home, first, begin_s, repair, math::seed_from(seed, "approach"));
  if (there.position.rows() == 0) {
    return {Reason::no_approach, no_path_reason(world, home, first, begin_s, repair)};
  }
  if (const PlanningFailure refused =
          time_and_certify(planner, world, there, options, begin_s, plan.approach)) {
    return {Reason::no_approach, sentence(refused)};
  }
  if (!options.retreat) return {};

  if (collision::target_state_at(world, end_s) == collision::TargetState::attached) {
    return {Reason::no_retreat, "the target is still in the hand at the end"};
  }
  const JointPath back =
      repair::plan_transit(world, last, home, end_s, repair, math::seed_from(seed, "retreat"));
  const bool found = back.position.rows() > 0;
  PlanningFailure refused;
  if (found) refused = time_and_certify(planner, world, back, options, end_s, plan.retreat);
  if (!found || refused) {
    refused =
        time_and_certify(planner, world, reverse_path(way, there), options, end_s, plan.retreat);
  }
  if (!refused) return {};
  return {Reason::no_retreat,
          found ? sentence(refused) : no_path_reason(world, last, home, end_s, repair)};
}

}  // namespace morphe::planning
