#include "stages/map/path_problem.hpp"

#include <algorithm>
#include <cmath>

#include "core/humanlike/arm_chain.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/constants.hpp"

namespace morphe::map {
namespace {

bool has_wrist_motion(const MappingProblem& problem) {
  return problem.wrist_motion > 0 && !problem.robot->arm_centres.empty() &&
         std::ranges::any_of(problem.goals, [](const auto& goal) { return is_known(goal.wrist); });
}

JointVector append(const JointVector& joints, double value) {
  JointVector all(joints.size() + 3);
  all << joints, value, value, value;
  return all;
}

/// Adds the term of one frame at (q, o). `poses` are those at q. Without the curvature of the
/// kinematics: the residuals are small beside the links.
void add_wrist_motion(const MappingProblem& problem, std::size_t frame,
                      const JointVector& variables, const std::vector<Pose>& poses,
                      solve::Quadratic& model) {
  const humanlike::FrameGoal& goal = problem.goals[frame];
  if (!is_known(goal.wrist)) return;
  const humanlike::ArmWrist wrist = humanlike::arm_wrist(*problem.robot, poses);
  const Eigen::Index joints = variables.size() - 3;
  Eigen::Matrix3Xd jacobian(3, variables.size());
  robot::point_jacobian(*problem.robot, poses, wrist.frame, wrist.position,
                        jacobian.leftCols(joints));
  jacobian.rightCols(3) = -Eigen::Matrix3d::Identity();
  const Vec3 residual = wrist.position - goal.wrist - variables.tail<3>();
  const double weight = kWristFollowing_per_m2 * goal.weights.humanlike_arm;
  model.value += weight * residual.squaredNorm();
  model.gradient += 2 * weight * (jacobian.transpose() * residual);
  model.hessian += 2 * weight * (jacobian.transpose() * jacobian);
}

}  // namespace

PathProblem::PathProblem(const MappingProblem& problem, const MovementCost& cost)
    : mapping(problem), has_offsets(has_wrist_motion(problem)), scratch(problem.frames()) {
  const double share = mean_step(problem.time) / kReferenceStep_s;
  movement.frames = static_cast<Eigen::Index>(problem.frames());
  movement.lower = problem.robot->lower;
  movement.upper = problem.robot->upper;
  movement.difference_weight = difference_weights(*problem.robot, problem.time, cost);
  if (!has_offsets) {
    movement.frame_model = [this, share](Eigen::Index frame, const JointVector& q,
                                         solve::Quadratic& model) {
      add_frame_objective(mapping, frame, q, scratch[frame], model, humanlike::Curvature::exact);
      model.scale(share);
    };
    return;
  }
  movement.lower = append(movement.lower, -kLargestWristOffset_m);
  movement.upper = append(movement.upper, kLargestWristOffset_m);
  const double of_step = problem.wrist_motion * share / std::pow(mean_step(problem.time), 2);
  for (std::size_t order = 0; order < movement.difference_weight.size(); ++order) {
    JointVector& weight = movement.difference_weight[order];
    weight = append(weight, order == 0 ? of_step : 0);
  }
  movement.frame_model = [this, share](Eigen::Index frame, const JointVector& variables,
                                       solve::Quadratic& model) {
    const Eigen::Index joints = variables.size() - 3;
    MappingScratch& at_frame = scratch[frame];
    solve::Quadratic& of_joints = at_frame.model;
    of_joints.reset(joints);
    const JointVector q = variables.head(joints);
    add_frame_objective(mapping, frame, q, at_frame, of_joints, humanlike::Curvature::exact);
    model.value += of_joints.value;
    model.gradient.head(joints) += of_joints.gradient;
    model.hessian.topLeftCorner(joints, joints) += of_joints.hessian;
    add_wrist_motion(mapping, frame, variables, at_frame.base_from_frame, model);
    model.scale(share);
  };
}

JointRows PathProblem::with_offsets(const JointRows& path, const JointRows& offsets) const {
  if (!has_offsets) return path;
  JointRows all(path.rows(), path.cols() + 3);
  all << path, offsets;
  return all;
}

JointRows PathProblem::joints(const JointRows& variables) const {
  return has_offsets ? JointRows(variables.leftCols(variables.cols() - 3)) : variables;
}

JointRows wrist_offsets(const MappingProblem& problem, const JointRows& path) {
  JointRows offsets = JointRows::Zero(path.rows(), 3);
  std::vector<Pose> base_from_frame;
  Eigen::Index first = -1;
  for (Eigen::Index f = 0; f < path.rows(); ++f) {
    const Vec3& human = problem.goals[f].wrist;
    if (!is_known(human)) {
      if (first >= 0) offsets.row(f) = offsets.row(f - 1);
      continue;
    }
    robot::forward_kinematics(*problem.robot, path.row(f).transpose(), base_from_frame);
    const Vec3 wrist = humanlike::arm_wrist(*problem.robot, base_from_frame).position;
    offsets.row(f) = (wrist - human).transpose();
    if (first < 0) {
      first = f;
      offsets.topRows(f).rowwise() = offsets.row(f);
    }
  }
  return offsets;
}

solve::MovementMinimum minimise_path(const MappingProblem& problem, const JointRows& start,
                                     const MovementCost& cost,
                                     const solve::MovementOptions& options) {
  const PathProblem path(problem, cost);
  const JointRows offsets = path.has_offsets ? wrist_offsets(problem, start) : JointRows();
  solve::MovementMinimum found =
      solve::minimise_movement(path.movement, path.with_offsets(start, offsets), options);
  found.q = path.joints(found.q);
  return found;
}

}  // namespace morphe::map
