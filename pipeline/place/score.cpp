#include "pipeline/place/score.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/map/coarse_grid.hpp"

namespace morphe::place {
namespace {

using Eigen::Index;

/// An accumulator for a mean, 0 without values.
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
  constexpr double kLimitZone_rad = 0.15;
  double nearest = kLimitZone_rad;
  for (const int joint : robot.arm_joints) {
    nearest = std::min({nearest, q[joint] - robot.lower[joint], robot.upper[joint] - q[joint]});
  }
  return 1 - std::max(0.0, nearest) / kLimitZone_rad;
}

double speed_between(const robot::Robot& robot, const JointVector& a, const JointVector& b,
                     double time_s) {
  return ((b - a).cwiseAbs().array() / robot.velocity.array()).maxCoeff() / time_s;
}

/// The cost of a placement is known well before its postures converge.
constexpr int kMaxIterations = 12;
constexpr double kRelativeTolerance = 3e-4;

map::MappingProblem select_frames(const planning::PlacedMovement& placed,
                                  const SearchEffort& effort) {
  return map::problem_at_frames(
      placed.problem, planning::evenly_spaced_frames(placed.problem.frames(), effort.frames));
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
  return 500 * m.out_of_reach + 2e3 * m.tip_error_m + 100 * m.collision_share +
         1e3 * m.penetration_m + (m.upper_arm_error + 0.15 * m.palm_error) / kRadPerDegree +
         10 * m.near_limits + 10 * std::max(0.0, m.speed_ratio - 1);
}

PlacementMeasures measure(const map::MappingProblem& problem, const JointRows& q) {
  constexpr double kReachTolerance_m = 0.002, kMaxTipError_m = 0.2;
  const robot::Robot& robot = *problem.robot;
  Mean out, tip_error, colliding, depth, upper_arm, palm, limits;
  PlacementMeasures measures;
  std::vector<Pose> frames;
  collision::CollisionScratch scratch;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const JointVector at = q.row(f).transpose();
    const humanlike::FrameGoal& goal = problem.goals[f];
    robot::forward_kinematics(robot, at, frames);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      if (!is_known(goal.tip_position[tip])) continue;
      const double error =
          (robot::tracked_point(robot, frames, tip, goal.tip_to_pad_share_of(tip)) -
           goal.tip_position[tip])
              .norm();
      out.add(error > kReachTolerance_m ? 1 : 0);
      tip_error.add(std::min(error, kMaxTipError_m));
    }
    const double lack = std::max(
        0.0, -collision::least_slack(*problem.world, at, problem.time[f], scratch).slack());
    colliding.add(lack > 0 ? 1 : 0);
    depth.add(lack);
    const Vec3 shoulder = frames[robot.shoulder_frame].translation();
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, frames);
    const Vec3 human = goal.elbow - goal.shoulder;
    if (!centres.empty() && is_known(human))
      upper_arm.add(angle_between_vectors(human, centres.front() - shoulder));
    if (is_known(goal.hand)) {
      const Pose& hand = frames[robot.palm_frame];
      palm.add(angle_between(Quat(hand.linear()), goal.hand));
    }
    limits.add(limit_proximity(robot, at));
    if (f == 0) continue;
    const JointVector before = q.row(f - 1).transpose();
    measures.speed_ratio =
        std::max(measures.speed_ratio,
                 speed_between(robot, before, at, problem.time[f] - problem.time[f - 1]));
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

planning::PipelineConfig trial_config(const planning::PipelineConfig& config,
                                      const BasePlacement& stand, const SearchEffort& effort) {
  planning::PipelineConfig tried = config;
  tried.placement = placement_of(stand);
  tried.map.base_offset.limit_m = 0;
  tried.map.key_frames = effort.key_frames;
  tried.map.starts = effort.starts;
  tried.map.candidates = 2;
  solve::MovementOptions& movement = tried.map.movement_solver;
  movement.max_iterations = std::min(movement.max_iterations, kMaxIterations);
  movement.relative_tolerance = std::max(movement.relative_tolerance, kRelativeTolerance);
  return tried;
}

TrialMapping map_from_random_starts(const planning::PlanningInputs& planner,
                                    const BasePlacement& stand, const TrialMovement& trial,
                                    const SearchEffort& effort, std::uint64_t seed) {
  const planning::PipelineConfig config = trial_config(planner.config, stand, effort);
  const planning::PlacedMovement placed({config, planner.robot}, trial.motion, trial.movement,
                                        trial.surroundings, Vec3::Zero());
  const map::MappingProblem few = select_frames(placed, effort);
  TrialMapping tried;
  tried.q = map::search_movement(few, config.map, seed).front().q;
  tried.measures = measure(few, tried.q);
  return tried;
}

TrialMapping map_from_warm_start(const planning::PlanningInputs& planner,
                                 const BasePlacement& stand, const TrialMovement& trial,
                                 const SearchEffort& effort, const JointRows& near) {
  const planning::PipelineConfig config = trial_config(planner.config, stand, effort);
  const planning::PlacedMovement placed({config, planner.robot}, trial.motion, trial.movement,
                                        trial.surroundings, Vec3::Zero());
  const map::MappingProblem few = select_frames(placed, effort);
  TrialMapping tried;
  tried.q = map::smooth_movement(few, near, config.map).q;
  tried.measures = measure(few, tried.q);
  return tried;
}

}  // namespace morphe::place
