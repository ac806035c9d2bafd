#include "pipeline/place/score.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/map/coarse_grid.hpp"

namespace morphe::place {
namespace {
struct Mean {
  double sum = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return count > 0 ? sum / count : 0; }
};

double angle_between_vectors(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double limit_proximity(const robot::Robot& robot, const JointVector& q) {
  double margin = kLimitZone_rad;
  for (const int joint : robot.arm_joints)
    margin = std::min({margin, q[joint] - robot.lower[joint], robot.upper[joint] - q[joint]});
  return 1 - std::max(0.0, margin) / kLimitZone_rad;
}

double speed_between(const robot::Robot& robot, const JointVector& a, const JointVector& b,
                     double time_s) {
  return ((b - a).cwiseAbs().array() / robot.velocity.array()).maxCoeff() / time_s;
}

planning::PipelineConfig trial_config(const planning::PipelineConfig& config,
                                      const BasePlacement& pose, const SearchEffort& effort) {
  planning::PipelineConfig trial = config;
  trial.placement = placement_of(pose);
  trial.map.base_offset.limit_m = 0;
  trial.map.key_frames = effort.key_frames;
  trial.map.starts = effort.starts;
  trial.map.candidates = 2;
  trial.map.branch = map::BranchRule::best;  // a reference of every pose would cost a search
  solve::MovementOptions& movement = trial.map.movement_solver;
  movement.max_iterations = std::min(movement.max_iterations, kMaxIterations);
  movement.relative_tolerance = std::max(movement.relative_tolerance, kRelativeTolerance);
  return trial;
}

/// Evaluates a pose by the postures that `solve` finds for effort.frames evenly spaced frames.
template <class Solve>
TrialMapping map_trial(const planning::PlanningInputs& planner, const BasePlacement& pose,
                       const TrialMovement& trial, const SearchEffort& effort, const Solve& solve) {
  const planning::PipelineConfig config = trial_config(planner.config, pose, effort);
  const planning::PlacedMovement placed({config, planner.robot}, trial.motion, trial.movement,
                                        trial.surroundings, Vec3::Zero());
  const map::MappingProblem problem = map::problem_at_frames(
      placed.problem, planning::evenly_spaced_indices(placed.problem.frames(), effort.frames));
  TrialMapping mapping{solve(problem, config.map), {}};
  mapping.measures = measure(problem, mapping.q);
  return mapping;
}

}  // namespace

PlacementMeasures mean_of(const std::vector<PlacementMeasures>& all) {
  PlacementMeasures mean;
  const double share = 1.0 / static_cast<double>(all.size());
  for (const PlacementMeasures& one : all) {
    for (const auto part : {&PlacementMeasures::out_of_reach, &PlacementMeasures::tip_error_m,
                            &PlacementMeasures::collision_share, &PlacementMeasures::penetration_m,
                            &PlacementMeasures::upper_arm_error, &PlacementMeasures::palm_error,
                            &PlacementMeasures::near_limits, &PlacementMeasures::speed_ratio}) {
      mean.*part += share * one.*part;
    }
  }
  return mean;
}

double cost_of(const PlacementMeasures& m) {
  return kOutOfReachWeight * m.out_of_reach + kTipErrorWeight_per_m * m.tip_error_m +
         kCollisionWeight * m.collision_share + kPenetrationWeight_per_m * m.penetration_m +
         (m.upper_arm_error + kPalmWeight * m.palm_error) / kRadPerDegree +
         kNearLimitsWeight * m.near_limits + kSpeedWeight * std::max(0.0, m.speed_ratio - 1);
}

PlacementMeasures measure(const map::MappingProblem& problem, const JointRows& q) {
  const robot::Robot& robot = *problem.robot;
  Mean out, tip_error, colliding, depth, upper_arm, palm, limits;
  PlacementMeasures measures;
  std::vector<Pose> frames;
  collision::CollisionScratch scratch;
  for (int f = 0; f < std::ssize(problem.time); ++f) {
    const JointVector posture = q.row(f).transpose();
    const humanlike::FrameGoal& goal = problem.goals[f];
    robot::forward_kinematics(robot, posture, frames);
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      if (!is_known(goal.tip_position[tip])) continue;
      const double error =
          (robot::tracked_point(robot, frames, tip, goal.tip_to_pad_share_of(tip)) -
           goal.tip_position[tip])
              .norm();
      out.add(error > kReachTolerance_m ? 1 : 0);
      tip_error.add(std::min(error, kMaxTipError_m));
    }
    const double deficit = std::max(
        0.0, -collision::least_slack(*problem.world, posture, problem.time[f], scratch).slack());
    colliding.add(deficit > 0 ? 1 : 0);
    depth.add(deficit);
    const Vec3 shoulder = frames[robot.shoulder_frame].translation();
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, frames);
    const Vec3 human = goal.elbow - goal.shoulder;
    if (!centres.empty() && is_known(human))
      upper_arm.add(angle_between_vectors(human, centres.front() - shoulder));
    if (is_known(goal.hand))
      palm.add(angle_between(Quat(frames[robot.palm_frame].linear()), goal.hand));
    limits.add(limit_proximity(robot, posture));
    if (f == 0) continue;
    const JointVector before = q.row(f - 1).transpose();
    measures.speed_ratio =
        std::max(measures.speed_ratio,
                 speed_between(robot, before, posture, problem.time[f] - problem.time[f - 1]));
  }
  measures.out_of_reach = out.value();
  measures.tip_error_m = tip_error.value();
  measures.collision_share = colliding.value();
  measures.penetration_m = depth.value();
  measures.upper_arm_error = upper_arm.value();
  measures.palm_error = palm.value();
  measures.near_limits = limits.value();
  return measures;
}

TrialMapping map_from_random_starts(const planning::PlanningInputs& planner,
                                    const BasePlacement& pose, const TrialMovement& trial,
                                    const SearchEffort& effort, std::uint64_t seed) {
  return map_trial(planner, pose, trial, effort, [&](const auto& problem, const auto& options) {
    return map::search_movement(problem, options, seed).front().q;
  });
}

TrialMapping map_from_warm_start(const planning::PlanningInputs& planner, const BasePlacement& pose,
                                 const TrialMovement& trial, const SearchEffort& effort,
                                 const JointRows& start) {
  return map_trial(planner, pose, trial, effort, [&](const auto& problem, const auto& options) {
    return map::smooth_movement(problem, start, options).q;
  });
}

}  // namespace morphe::place
