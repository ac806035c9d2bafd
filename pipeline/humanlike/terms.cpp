#include "pipeline/humanlike/terms.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/robot/forward.hpp"

namespace morphe::humanlike {
namespace {

const Pose& pose_of(const RobotState& state, int frame) {
  return state.base_from_frame[static_cast<std::size_t>(frame)];
}

Vec3 tip_position(const RobotState& state, const RobotTable::Tip& tip) {
  if (tip.frame < 0) return tip.transform.translation();
  const Pose& pose = pose_of(state, tip.frame);
  return pose.linear() * tip.transform.translation() + pose.translation();
}

/// weight * sqrt(d² + e²), d half the angle θ from goal to current about n. By a small turn about
/// the base's axes: slope d / (2 sqrt(d² + e²)) along n; curvature across n slope * cot(θ/2) / 2;
/// along n that of the smoothed angle, e² / (4 sqrt³), seen through its memory (AngleMemory).
void add_angle(int frame, const Quat& current, const Quat& goal, double weight, double smoothing,
               AngleMemory& memory, Loads& loads) {
  const Quat turn = current * goal.conjugate();
  const double sine = turn.vec().norm(), cosine = std::abs(turn.w());
  const double half = std::atan2(sine, cosine);
  const double smooth = std::sqrt(half * half + smoothing * smoothing);
  const Vec3 axis = sine > 0 ? Vec3(std::copysign(1 / sine, turn.w()) * turn.vec()) : Vec3::UnitZ();
  loads.value += weight * smooth;
  const Vec3 gradient = (0.5 * weight * half / smooth) * axis;
  if (loads.curvature == Curvature::none) {
    return loads.add_turn(frame, gradient, Eigen::Matrix3d::Zero());
  }

  double along = 1;
  if (loads.curvature == Curvature::exact) {
    const Vec3 now = half * axis;
    if (memory.smooth > 0) {
      const double before = memory.smooth;
      const double stretch = memory.half.dot(now - memory.half) / (before * before);
      memory.slope = now / before - stretch * memory.slope;
      const double norm = memory.slope.norm();
      if (norm > 1) memory.slope /= norm;
    }
    memory.half = now;
    memory.smooth = smooth;
    along = 1 - std::max(0.0, memory.slope.dot(axis)) * half / smooth;
  }
  // half * cos / sin -> 1 at 0: across the axis an angle is as curved as along it.
  const double across = sine > 1e-6 ? half * cosine / sine : 1;
  const double scale = 0.25 * weight / smooth;
  Eigen::Matrix3d hessian = (scale * (along - across)) * (axis * axis.transpose());
  hessian.diagonal().array() += scale * across;
  loads.add_turn(frame, gradient, hessian);
}

/// The tip at the end of the finger that a centre belongs to; -1: the arm's, or no finger's.
int tip_beyond(const RobotTable& robot, const RobotTable::Centre& centre) {
  if (centre.chain == "arm") return -1;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (robot.tips[tip].finger < 0) continue;
    int frame = robot.tips[tip].frame;  // parents come first
    while (frame > centre.frame) frame = robot.frames[static_cast<std::size_t>(frame)].parent;
    if (frame == centre.frame) return static_cast<int>(tip);
  }
  return -1;
}

/// weight * ‖reference - s_j‖², divided by the number of centres of the same chain.
void add_centre(const RobotState& state, const RobotTable::Centre& centre, const Vec3& reference,
                double weight, Loads& loads) {
  if (!seen(reference)) return;
  const auto count =
      std::count_if(state.robot.centres.begin(), state.robot.centres.end(),
                    [&](const RobotTable::Centre& other) { return other.chain == centre.chain; });
  loads.add_point(centre.frame, pose_of(state, centre.frame).translation(),
                  reference + state.offset, weight / static_cast<double>(count), false);
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

void TipPosition::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  const double share = weight * goal.weights.tip_position;
  if (share == 0) return;
  for (std::size_t i = 0; i < state.robot.tips.size(); ++i) {
    if (!seen(goal.tip_position[i])) continue;
    const RobotTable::Tip& tip = state.robot.tips[i];
    loads.add_point(tip.frame, tip_position(state, tip), goal.tip_position[i] + state.offset, share,
                    true);
  }
}

void TipOrientation::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  const double share = weight * goal.weights.tip_orientation;
  if (share == 0) return;
  for (std::size_t i = 0; i < state.robot.tips.size(); ++i) {
    if (!seen(goal.tip_orientation[i])) continue;
    const RobotTable::Tip& tip = state.robot.tips[i];
    const Quat in_frame(tip.transform.linear());
    const Quat current =
        tip.frame < 0 ? in_frame : Quat(pose_of(state, tip.frame).linear()) * in_frame;
    add_angle(tip.frame, current, goal.tip_orientation[i], share, smoothing_rad, loads.next_angle(),
              loads);
  }
}

void HandOrientation::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  const double share = weight * goal.weights.tip_orientation;
  if (share == 0 || !seen(goal.hand) || goal.tips_seen() >= 3) return;
  const int palm = state.robot.palm_frame;
  add_angle(palm, Quat(pose_of(state, palm).linear()), goal.hand, share, smoothing_rad,
            loads.next_angle(), loads);
}

void JointDistance::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  const double share = weight * goal.weights.humanlike_arm;
  if (share == 0 || !seen(goal.elbow)) return;
  for (const RobotTable::Centre& centre : state.robot.centres) {
    if (centre.chain == "arm") add_centre(state, centre, goal.elbow, share, loads);
  }
}

void FingerJointDistance::add(const RobotState& state, const FrameGoal& goal, Loads& loads) const {
  const double share = weight * goal.weights.humanlike_fingers;
  if (share == 0) return;
  for (const RobotTable::Centre& centre : state.robot.centres) {
    const int beyond = tip_beyond(state.robot, centre);
    if (beyond < 0) continue;
    const auto i = static_cast<std::size_t>(beyond);
    const RobotTable::Tip& tip = state.robot.tips[i];
    if (!std::isfinite(tip.along)) {
      add_centre(state, centre, goal.finger_joint[static_cast<std::size_t>(tip.finger)], share,
                 loads);
    } else if (i < goal.curve_joint.size()) {
      add_centre(state, centre, goal.curve_joint[i], share, loads);
    }
  }
}

void NaturalPosture::add(const RobotState& state, const FrameGoal& goal,
                         solve::Quadratic& model) const {
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

void JointAngle::add(const RobotState& state, const FrameGoal& goal,
                     solve::Quadratic& model) const {
  if (weight == 0) return;
  for (Eigen::Index j = 0; j < goal.angles.size(); ++j) {
    const double error = state.q[j] - goal.angles[j];
    if (std::isnan(error)) continue;
    model.value += weight * error * error;
    model.gradient[j] += 2 * weight * error;
    model.hessian(j, j) += 2 * weight;
  }
}

void FreeOffset::add(const RobotState& state, solve::Quadratic& model) const {
  if (!free) return;
  model.value += weight * state.offset.squaredNorm();
  model.gradient.tail<3>() += 2 * weight * state.offset;
  model.hessian.diagonal().tail<3>().array() += 2 * weight;
}

}  // namespace morphe::humanlike
