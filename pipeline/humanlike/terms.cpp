#include "pipeline/humanlike/terms.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/kinematics/forward.hpp"

namespace morphe {
namespace {

using Jacobian = Eigen::Matrix3Xd;

Jacobian jacobian_of(const RobotState& state, int frame, const Vec3& point) {
  Jacobian jacobian(3, state.q.size());
  point_jacobian(state.robot, state.base_from_frame, frame, point, jacobian);
  return jacobian;
}

/// weight * sqrt(d² + e²), d half the angle between current and goal: a reweighted square of the
/// half rotation vector, so that the gradient is exact and the Hessian positive semidefinite.
void add_rotation(const RobotState& state, int frame, const Quat& current, const Quat& goal,
                  double weight, double smoothing_rad, Quadratic& model) {
  Eigen::AngleAxisd error(current * goal.conjugate());
  double angle = error.angle();
  if (angle > std::numbers::pi) angle -= 2 * std::numbers::pi;
  const Vec3 half = 0.5 * angle * error.axis();
  const double smooth = std::sqrt(half.squaredNorm() + smoothing_rad * smoothing_rad);
  Jacobian jacobian(3, state.q.size());
  rotation_jacobian(state.robot, state.base_from_frame, frame, jacobian);
  // d(half)/dq along the rotation axis is exactly half the angular velocity; across it the
  // difference is of second order in the gradient, since half is parallel to the axis.
  jacobian *= 0.5;
  const double before = model.value;
  model.add_squares(weight / (2 * smooth), half, jacobian);
  model.value = before + weight * smooth;
}

void add_point(const RobotState& state, int frame, const Vec3& point, const Vec3& goal,
               double weight, Quadratic& model) {
  model.add_squares(weight, Vec3(point - goal), jacobian_of(state, frame, point));
}

Vec3 centre_position(const RobotState& state, const RobotTable::Centre& centre) {
  return state.base_from_frame[static_cast<std::size_t>(centre.frame)].translation();
}

void add_centres(const RobotState& state, const std::string& chain, const Vec3& reference,
                 double weight, Quadratic& model) {
  if (!seen(reference)) return;
  const auto count = std::count_if(state.robot.centres.begin(), state.robot.centres.end(),
                                   [&](const auto& centre) { return centre.chain == chain; });
  for (const RobotTable::Centre& centre : state.robot.centres) {
    if (centre.chain != chain) continue;
    add_point(state, centre.frame, centre_position(state, centre), reference,
              weight / static_cast<double>(count), model);
  }
}

bool active(const NaturalPosture::Joint& entry, const FrameGoal& goal) {
  return std::none_of(entry.tips.begin(), entry.tips.end(), [&](int tip) {
    return seen(goal.tip_position[static_cast<std::size_t>(tip)]);
  });
}

double posture_error(const NaturalPosture::Joint& entry, const JointVector& q) {
  return q[entry.joint] - (entry.follow < 0 ? 0.0 : q[entry.follow]) - entry.value;
}

}  // namespace

void TipPosition::add(const RobotState& state, const FrameGoal& goal, Quadratic& model) const {
  if (weight == 0) return;
  for (std::size_t i = 0; i < state.robot.tips.size(); ++i) {
    if (!seen(goal.tip_position[i])) continue;
    const Vec3 tip = tip_pose(state.robot, state.base_from_frame, i).translation();
    add_point(state, state.robot.tips[i].frame, tip, goal.tip_position[i], weight, model);
  }
}

void TipOrientation::add(const RobotState& state, const FrameGoal& goal, Quadratic& model) const {
  if (weight == 0) return;
  for (std::size_t i = 0; i < state.robot.tips.size(); ++i) {
    if (!seen(goal.tip_orientation[i])) continue;
    const Quat tip(tip_pose(state.robot, state.base_from_frame, i).linear());
    add_rotation(state, state.robot.tips[i].frame, tip, goal.tip_orientation[i], weight,
                 smoothing_rad, model);
  }
}

void HandOrientation::add(const RobotState& state, const FrameGoal& goal, Quadratic& model) const {
  if (weight == 0 || !seen(goal.hand) || goal.tips_seen() >= 3) return;
  const int palm = state.robot.palm_frame;
  const Quat hand(state.base_from_frame[static_cast<std::size_t>(palm)].linear());
  add_rotation(state, palm, hand, goal.hand, weight, smoothing_rad, model);
}

void JointDistance::add(const RobotState& state, const FrameGoal& goal, Quadratic& model) const {
  if (weight != 0) add_centres(state, "arm", goal.elbow, weight, model);
}

void FingerJointDistance::add(const RobotState& state, const FrameGoal& goal,
                              Quadratic& model) const {
  if (weight == 0) return;
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    add_centres(state, kFingerNames[finger], goal.finger_joint[finger], weight, model);
  }
}

void NaturalPosture::add(const RobotState& state, const FrameGoal& goal, Quadratic& model) const {
  for (const Joint& entry : joints) {
    if (!active(entry, goal)) continue;
    const double error = posture_error(entry, state.q);
    model.value += weight * error * error;
    model.gradient[entry.joint] += 2 * weight * error;
    model.hessian(entry.joint, entry.joint) += 2 * weight;
    if (entry.follow < 0) continue;
    model.gradient[entry.follow] -= 2 * weight * error;
    model.hessian(entry.follow, entry.follow) += 2 * weight;
    model.hessian(entry.joint, entry.follow) -= 2 * weight;
    model.hessian(entry.follow, entry.joint) -= 2 * weight;
  }
}

double NaturalPosture::distance(const JointVector& q, const FrameGoal& goal) const {
  double sum = 0;
  int count = 0;
  for (const Joint& entry : joints) {
    if (!active(entry, goal)) continue;
    const double error = posture_error(entry, q);
    sum += error * error;
    ++count;
  }
  return count == 0 ? kNotSeen : std::sqrt(sum / count);
}

}  // namespace morphe
