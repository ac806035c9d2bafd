#include "pipeline/planning/approach.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/seed.hpp"
#include "pipeline/planning/constants.hpp"
#include "pipeline/planning/planner.hpp"
#include "pipeline/planning/smoothing_fallback.hpp"
#include "stages/certify/certify.hpp"
#include "stages/repair/repair_strategy.hpp"
#include "stages/repair/transit.hpp"

namespace morphe::planning {
namespace {

double end_error(const JointPath& path, const Trajectory& trajectory) {
  const auto difference = [](const auto& reached, const auto& wanted) {
    return (reached - wanted).cwiseAbs().maxCoeff();
  };
  return std::max(difference(trajectory.position.topRows(1), path.position.topRows(1)),
                  difference(trajectory.position.bottomRows(1), path.position.bottomRows(1)));
}

/// Sets `trajectory` to the fastest motion along the path, at the demonstration time `time_s`, and
/// certifies it. Smoothing is disabled if it causes a collision or misses an end.
PlanningFailure time_and_certify(const PlanningInputs& planner,
                                 const collision::CollisionWorld& world, const JointPath& path,
                                 const ApproachOptions& options, double time_s,
                                 Trajectory& trajectory) {
  retime::RetimeOptions time_law = planner.config.retime;
  time_law.mode = retime::RetimeMode::fastest;
  time_law.duration_s.reset();
  time_law.phase_speed.clear();
  time_law.limit_scaling *= options.limit_scaling;
  const auto attempt = [&](const retime::RetimeOptions& smoothing) -> PlanningFailure {
    Outcome<retime::RetimeResult> retimed =
        retime::retime(planner.robot, path, Movement{}, smoothing);
    if (retimed.failure) return retimed.failure;
    trajectory = std::move(retimed.value.trajectory);
    // The demonstration time stands still, so that contacts are permitted as at that moment.
    std::ranges::fill(trajectory.demonstration_time, time_s);
    std::ranges::fill(trajectory.phase, PhaseKind::rest);
    const PlanningFailure failure = certify::certify_motion(world, trajectory).failure;
    const double error = end_error(path, trajectory);
    if (failure || error <= kEndTolerance) return failure;
    return {Reason::smoothing_collision,
            fmt::format("the smoothed curve misses an endpoint by {:.2g} rad or m", error)};
  };
  return retry_without_smoothing(time_law, {Reason::smoothing_collision}, attempt);
}

std::string sentence(const PlanningFailure& failure) {
  return fmt::format("{}: {}", name_of(failure.reason), failure.detail);
}

/// Returns why there is no path between two postures: one of them collides, or the search failed.
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

/// Returns a plan's reversed motion and reversed approach. The times only order the samples.
JointPath reverse_path(const Trajectory& trajectory, const JointPath& approach) {
  std::vector<JointVector> rows;
  for (Eigen::Index k = trajectory.position.rows() - 1; k > 0; k -= kReverseSampleStride) {
    rows.push_back(trajectory.position.row(k).transpose());
  }
  for (Eigen::Index k = approach.position.rows() - 1; k >= 0; --k) {
    rows.push_back(approach.position.row(k).transpose());
  }
  JointPath reversed;
  reversed.position.resize(rows.size(), trajectory.position.cols());
  reversed.origin.assign(rows.size(), SampleOrigin::planned);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    reversed.position.row(k) = rows[k].transpose();
    reversed.demonstration_time.push_back(0.01 * static_cast<double>(k));
  }
  return reversed;
}

}  // namespace

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
  const Trajectory& motion = plan.trajectory;
  const double begin_s = motion.demonstration_time.front(),
               end_s = motion.demonstration_time.back();
  const JointVector first = motion.position.row(0).transpose();
  const JointVector last = motion.position.row(motion.position.rows() - 1).transpose();

  const JointPath approach_path =
      repair::plan_transit(world, home, first, begin_s, repair, math::seed_from(seed, "approach"));
  if (approach_path.position.rows() == 0) {
    return {Reason::no_approach, no_path_reason(world, home, first, begin_s, repair)};
  }
  if (const PlanningFailure refused =
          time_and_certify(planner, world, approach_path, options, begin_s, plan.approach)) {
    return {Reason::no_approach, sentence(refused)};
  }
  std::ranges::fill(plan.approach.phase, PhaseKind::approach);
  if (!options.retreat) return {};

  if (collision::target_state_at(world, end_s) == collision::TargetState::attached) {
    return {Reason::no_retreat, "the target is still in the hand at the end"};
  }
  const JointPath retreat_path =
      repair::plan_transit(world, last, home, end_s, repair, math::seed_from(seed, "retreat"));
  const bool found = retreat_path.position.rows() > 0;
  PlanningFailure refused;
  if (found) refused = time_and_certify(planner, world, retreat_path, options, end_s, plan.retreat);
  if (!found || refused) {
    refused = time_and_certify(planner, world, reverse_path(motion, approach_path), options, end_s,
                               plan.retreat);
  }
  std::ranges::fill(plan.retreat.phase, PhaseKind::retreat);
  if (!refused) return {};
  return {Reason::no_retreat,
          found ? sentence(refused) : no_path_reason(world, last, home, end_s, repair)};
}

}  // namespace morphe::planning
