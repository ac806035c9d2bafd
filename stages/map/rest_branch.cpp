#include "stages/map/rest_branch.hpp"

#include "stages/map/coarse_grid.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::map {
namespace {

/// Returns the goal at a share of the way from rest, 0 … 1. The fingers have the shape of the goal.
humanlike::FrameGoal goal_between(const Reference& reference, const humanlike::FrameGoal& goal,
                                  double share) {
  const humanlike::FrameGoal& rest = reference.rest;
  const auto between = [&](const Vec3& from, const Vec3& to) -> Vec3 {
    return is_known(to) ? Vec3(from + share * (to - from)) : to;
  };
  humanlike::FrameGoal moved = goal;
  moved.shoulder = between(rest.shoulder, goal.shoulder);
  moved.elbow = between(rest.elbow, goal.elbow);
  moved.wrist = between(rest.wrist, goal.wrist);
  moved.hand = rest.hand.slerp(share, goal.hand);
  const Vec3 &offset = reference.common_base_offset, wrist = goal.wrist - offset;
  const Quat turn = moved.hand * goal.hand.conjugate();
  const Vec3 wrist_at_rest = rest.wrist - offset;
  for (std::size_t k = 0; k < moved.tip_position.size(); ++k) {
    Vec3& tip = moved.tip_position[k];
    if (!is_known(tip)) continue;
    Vec3 in_hand = goal.hand.conjugate() * (tip - wrist);
    if (is_known(rest.tip_position[k])) {
      const Vec3 at_rest = rest.hand.conjugate() * (rest.tip_position[k] - wrist_at_rest);
      in_hand = at_rest + share * (in_hand - at_rest);
    }
    tip = moved.wrist - offset + moved.hand * in_hand;
  }
  for (Quat& tip : moved.tip_orientation) {
    if (is_known(tip)) tip = turn * tip;
  }
  for (Vec3& joint : moved.finger_joint) {
    if (is_known(joint)) joint = moved.wrist + turn * (joint - goal.wrist);
  }
  for (Vec3& joint : moved.interpolated_finger_joint) {
    if (is_known(joint)) joint = moved.wrist + turn * (joint - goal.wrist);
  }
  return moved;
}

/// Returns the weights [n] with which a posture is held near the one before: a share of the cost of
/// velocity over a step of the coarse grid.
JointVector nearness_of(const robot::Robot& robot, const MapOptions& options) {
  const std::vector<double> step{0, options.coarse_step_s};
  return kRestNearness * difference_weights(robot, step, options.movement_cost).front();
}

}  // namespace

JointVector posture_from_rest(const MappingProblem& problem, const JointVector& posture,
                              const MapOptions& options, MappingScratch& scratch) {
  const solve::MinimiseOptions solver =
      limit_evaluations(options.frame_solver, kMaxRestEvaluations);
  const JointVector nearness = nearness_of(*problem.robot, options);
  const humanlike::FrameGoal& goal = problem.goals.front();
  JointVector q = posture;
  const bool can_move =
      is_known(problem.reference.rest.wrist) && is_known(goal.wrist) && is_known(goal.hand);
  MappingProblem between = problem_at_frames(problem, {0});
  for (int step = can_move ? 1 : kRestSteps; step <= kRestSteps; ++step) {
    const double share = static_cast<double>(step) / kRestSteps;
    if (can_move) between.goals.front() = goal_between(problem.reference, goal, share);
    between.clearance.weight = share * problem.clearance.weight;
    q = solve_frame_near(between, 0, q, nearness, solver, scratch).x;
  }
  return q;
}

IkBranch continue_from_rest(const MappingProblem& problem, const JointVector& posture,
                            const MapOptions& options, MappingScratch& scratch) {
  const solve::MinimiseOptions solver =
      limit_evaluations(options.frame_solver, kMaxRestEvaluations);
  const JointVector nearness = nearness_of(*problem.robot, options);
  JointVector q = posture_from_rest(problem, posture, options, scratch);
  const double share = mean_step(problem.time) / kReferenceStep_s;
  const auto frames = static_cast<Eigen::Index>(problem.frames());
  IkBranch branch{0, JointRows(frames, q.size()), std::vector<double>(problem.frames())};
  for (Eigen::Index f = 0; f < frames; ++f) {
    const solve::Minimum found = solve_frame_near(problem, f, q, nearness, solver, scratch);
    q = found.x;
    branch.q.row(f) = q.transpose();
    branch.frame_cost[f] = share * found.value;
  }
  return branch;
}

}  // namespace morphe::map
