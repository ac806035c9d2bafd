#include "pipeline/place/score.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward.hpp"
#include "pipeline/planning/place_movement.hpp"
#include "stages/map/coarse_grid.hpp"

namespace morphe::place {
namespace {

using Eigen::Index;

/// A mean that begins with nothing.
struct Mean {
  double sum = 0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return count > 0 ? sum / count : 0; }
};

double angle_of(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

double share_at_limits(const robot::Robot& robot, const JointVector& q) {
  constexpr double kNear = 0.15;
  double nearest = kNear;
  for (const int joint : robot.arm_joints) {
    nearest = std::min({nearest, q[joint] - robot.lower[joint], robot.upper[joint] - q[joint]});
  }
  return 1 - std::max(0.0, nearest) / kNear;
}

double speed_between(const robot::Robot& robot, const JointVector& a, const JointVector& b,
                     double time_s) {
  return ((b - a).cwiseAbs().array() / robot.velocity.array()).maxCoeff() / time_s;
}

/// A placement's worth shows long before its postures settle.
constexpr int kIterations = 12;
constexpr double kSettled = 3e-4;

map::MappingProblem few_of(const planning::PlacedMovement& placed, const Effort& effort) {
  return map::on_frames(placed.problem,
                        planning::few_frames(placed.problem.frames(), effort.frames));
}

}  // namespace

Measures mean_of(const std::vector<Measures>& all) {
  Measures mean;
  const double share = 1.0 / static_cast<double>(all.size());
  for (const Measures& one : all) {
    for (const auto part :
         {&Measures::out_of_reach, &Measures::tip_error_m, &Measures::colliding, &Measures::depth_m,
          &Measures::upper_arm, &Measures::palm, &Measures::near_limits, &Measures::speed}) {
      mean.*part += share * one.*part;
    }
  }
  return mean;
}

double cost_of(const Measures& m) {
  return 500 * m.out_of_reach + 2e3 * m.tip_error_m + 100 * m.colliding + 1e3 * m.depth_m +
         (m.upper_arm + 0.15 * m.palm) / kDegree + 10 * m.near_limits +
         10 * std::max(0.0, m.speed - 1);
}

Measures measure(const map::MappingProblem& problem, const JointRows& q) {
  constexpr double kMissed_m = 0.002, kMost_m = 0.2;
  const robot::Robot& robot = *problem.robot;
  Mean out, tip_error, colliding, depth, upper_arm, palm, limits;
  Measures measures;
  std::vector<Pose> frames;
  collision::CollisionScratch scratch;
  for (std::size_t f = 0; f < problem.frames(); ++f) {
    const JointVector at = q.row(static_cast<Index>(f)).transpose();
    const humanlike::FrameGoal& goal = problem.goals[f];
    robot::forward(robot, at, frames);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      if (!seen(goal.tip_position[tip])) continue;
      const double error =
          (robot::goal_point(robot, frames, tip, goal.pad_share_of(tip)) - goal.tip_position[tip])
              .norm();
      out.add(error > kMissed_m ? 1 : 0);
      tip_error.add(std::min(error, kMost_m));
    }
    const double lack = std::max(
        0.0, -collision::least_slack(*problem.world, at, problem.time[f], scratch).slack());
    colliding.add(lack > 0 ? 1 : 0);
    depth.add(lack);
    const Vec3 shoulder = frames[static_cast<std::size_t>(robot.shoulder_frame)].translation();
    const std::vector<Vec3> centres = robot::arm_centre_positions(robot, frames);
    const Vec3 human = goal.elbow - goal.shoulder;
    if (!centres.empty() && seen(human)) upper_arm.add(angle_of(human, centres.front() - shoulder));
    if (seen(goal.hand)) {
      const Pose& hand = frames[static_cast<std::size_t>(robot.palm_frame)];
      palm.add(angle_between(Quat(hand.linear()), goal.hand));
    }
    limits.add(share_at_limits(robot, at));
    if (f == 0) continue;
    const JointVector before = q.row(static_cast<Index>(f - 1)).transpose();
    measures.speed = std::max(
        measures.speed, speed_between(robot, before, at, problem.time[f] - problem.time[f - 1]));
  }
  measures.out_of_reach = out.value();
  measures.tip_error_m = tip_error.value();
  measures.colliding = colliding.value();
  measures.depth_m = depth.value();
  measures.upper_arm = upper_arm.value();
  measures.palm = palm.value();
  measures.near_limits = limits.value();
  return measures;
}

planning::PipelineConfig tried_config(const planning::PipelineConfig& config, const Stand& stand,
                                      const Effort& effort) {
  planning::PipelineConfig tried = config;
  tried.placement = placement_of(stand);
  tried.map.free_offset.limit_m = 0;
  tried.map.key_frames = effort.key_frames;
  tried.map.starts = effort.starts;
  tried.map.candidates = 2;
  solve::MovementOptions& movement = tried.map.movement;
  movement.iterations = std::min(movement.iterations, kIterations);
  movement.relative_value = std::max(movement.relative_value, kSettled);
  return tried;
}

Tried search(const planning::Planner& planner, const Stand& stand, const Trial& trial,
             const Effort& effort, std::uint64_t seed) {
  const planning::PipelineConfig config = tried_config(planner.config, stand, effort);
  const planning::PlacedMovement placed({config, planner.robot}, trial.motion, trial.movement,
                                        trial.around, Vec3::Zero());
  const map::MappingProblem few = few_of(placed, effort);
  Tried tried;
  tried.q = map::search_movement(few, config.map, seed).front().q;
  tried.measures = measure(few, tried.q);
  return tried;
}

Tried follow(const planning::Planner& planner, const Stand& stand, const Trial& trial,
             const Effort& effort, const JointRows& near) {
  const planning::PipelineConfig config = tried_config(planner.config, stand, effort);
  const planning::PlacedMovement placed({config, planner.robot}, trial.motion, trial.movement,
                                        trial.around, Vec3::Zero());
  const map::MappingProblem few = few_of(placed, effort);
  Tried tried;
  tried.q = map::smooth_movement(few, near, config.map).q;
  tried.measures = measure(few, tried.q);
  return tried;
}

}  // namespace morphe::place
