#include "stages/grasp/close_fingers.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::grasp {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::ranges::find(list, value) != list.end();
}

/// Returns the capsules that move with the finger of `tip` but not with the palm.
std::vector<int> capsules_of(const robot::Robot& robot, std::size_t tip) {
  std::vector<int> finger_capsules;
  const int palm = robot::moving_frame_of(robot, robot.palm_frame);
  std::vector<int> links;
  for (const int frame : robot::ancestors(robot, robot.tips[tip].frame)) {
    if (robot::moving_frame_of(robot, frame) == palm) break;
    links.push_back(robot::moving_frame_of(robot, frame));
  }
  for (int c = 0; c < std::ssize(robot.capsules); ++c) {
    if (contains(links, robot::moving_frame_of(robot, robot.capsules[c].frame)))
      finger_capsules.push_back(c);
  }
  return finger_capsules;
}

/// Distance queries for one finger at one posture.
struct Probe {
  const collision::CollisionWorld& world;
  std::vector<int> finger_capsules;   ///< capsules of the finger
  std::vector<int> ignored_capsules;  ///< of fingers not yet closed: the mapping moves them aside
  Pose base_from_target;
  collision::CollisionScratch scratch;

  void pose(const JointVector& q, double time_s) {
    collision::update_bodies(world, q, time_s, scratch);
  }
  collision::Separation separation_from_target(int capsule) const {
    return collision::capsule_solid(scratch.bodies[capsule],
                                    collision::solid_at(world, world.target), base_from_target);
  }
  /// Returns the name of a body, not the target, that is nearer to the finger than the margin, or
  /// "".
  std::string find_obstacle() const {
    const double margin = world.tolerances.required_clearance;
    for (const auto& [first, second] : world.pairs) {
      if (contains(finger_capsules, first) == contains(finger_capsules, second)) continue;
      if (contains(ignored_capsules, first) || contains(ignored_capsules, second)) continue;
      const auto body = [&](int c) { return scratch.bodies[c]; };
      if (collision::capsule_capsule(body(first), body(second)).distance >= margin) continue;
      const int other = contains(finger_capsules, first) ? second : first;
      return world.robot->capsules[other].name;
    }
    for (int k = 0; k < std::ssize(world.scene->objects); ++k) {
      if (k == world.target) continue;
      for (const int c : finger_capsules) {
        const auto separation = collision::capsule_solid(
            scratch.bodies[c], collision::solid_at(world, k), scratch.object_poses[k]);
        if (separation.distance < margin) return world.scene->objects[k].name;
      }
    }
    return "";
  }
};

}  // namespace

std::vector<std::pair<int, double>> closing_joints(const robot::Robot& robot, const JointVector& q,
                                                   std::size_t tip) {
  const robot::Pad& pad = robot.pads[tip];
  const int frame = robot.tips[tip].frame;
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, q, base_from_frame);
  const Pose& pose = base_from_frame[frame];
  Eigen::Matrix3Xd jacobian(3, q.size());
  robot::point_jacobian(robot, base_from_frame, frame, pose * pad.centre, jacobian);
  const Eigen::RowVectorXd closing_rate = (pose.linear() * pad.direction).transpose() * jacobian;
  std::vector<std::pair<int, double>> joints;
  double max_rate = 0;
  const auto of_finger = [&](int j) { return !contains(robot.arm_joints, j); };
  for (int j = 0; j < q.size(); ++j) {
    if (of_finger(j)) max_rate = std::max(max_rate, std::abs(closing_rate[j]));
  }
  for (int j = 0; j < q.size(); ++j) {
    if (!of_finger(j) || std::abs(closing_rate[j]) <= kMinLeverRatio * max_rate) continue;
    joints.emplace_back(j, closing_rate[j] > 0 ? 1.0 : -1.0);
  }
  return joints;
}

namespace {

/// Returns q with `angle` added to the finger's joints that do not close it, within their limits.
JointVector abduct_finger(const robot::Robot& robot, const JointVector& q, std::size_t tip,
                          double angle) {
  const std::vector<std::pair<int, double>> closing = closing_joints(robot, q, tip);
  JointVector abducted = q;
  for (int j = 0; j < q.size(); ++j) {
    const bool closes =
        std::ranges::any_of(closing, [&](const auto& joint) { return joint.first == j; });
    if (closes || contains(robot.arm_joints, j)) continue;
    if (!robot::joint_moves_frame(robot, j, robot.tips[tip].frame)) continue;
    abducted[j] = std::clamp(q[j] + angle, robot.lower[j], robot.upper[j]);
  }
  return abducted;
}

/// Closes one finger, abducted by `angle`. Sets q to the touching posture; without a contact,
/// returns nullopt and sets `reason`.
std::optional<FingerClosure> close_finger(Probe& probe, double time_s, std::size_t tip,
                                          double angle, JointVector& q, std::string& reason) {
  const collision::CollisionWorld& world = probe.world;
  const robot::Robot& robot = *world.robot;
  const int pad_capsule = robot.pads[tip].capsule;
  JointVector posture = abduct_finger(robot, q, tip, angle);
  std::vector<std::pair<int, double>> joints = closing_joints(robot, posture, tip);
  const auto stop_before = [&](int capsule) {  // removes the joints that move the touching link
    const int frame = robot.capsules[capsule].frame;
    return std::erase_if(joints, [&](const auto& joint) {
      return robot::joint_moves_frame(robot, joint.first, frame);
    });
  };
  const auto step_joints = [&](const JointVector& from, double step) {
    JointVector to = from;
    for (const auto& [joint, sign] : joints) {
      to[joint] = std::clamp(from[joint] + sign * step, robot.lower[joint], robot.upper[joint]);
    }
    return to;
  };
  probe.pose(posture, time_s);
  for (double opened = 0; probe.separation_from_target(pad_capsule).distance < 0;
       opened += kClosingStep_rad) {
    const JointVector open = step_joints(posture, -kClosingStep_rad);
    if (opened > kMaxOpening_rad || open == posture) {
      reason = "it is already inside the target";
      return std::nullopt;
    }
    posture = open;
    probe.pose(posture, time_s);
  }
  while (!joints.empty()) {
    const JointVector next = step_joints(posture, kClosingStep_rad);
    if (next == posture) {
      reason = "it does not reach the target within its limits";
      return std::nullopt;
    }
    probe.pose(next, time_s);
    if (const std::string obstacle = probe.find_obstacle(); !obstacle.empty()) {
      reason = "it would collide with " + obstacle;
      return std::nullopt;
    }
    double gap = probe.separation_from_target(pad_capsule).distance;
    if (gap <= 0) {
      double low = 0, high = 1;  // bounds of the bisection, as shares of the step
      JointVector touching = next;
      while (gap < 0 || gap > kContactTolerance_m) {
        const double share = 0.5 * (low + high);
        touching = posture + share * (next - posture);
        probe.pose(touching, time_s);
        gap = probe.separation_from_target(pad_capsule).distance;
        (gap > 0 ? low : high) = share;
        if (high - low < 1e-9) break;
      }
      const collision::Separation separation = probe.separation_from_target(pad_capsule);
      const Pose target_from_base = probe.base_from_target.inverse();
      FingerClosure closing;
      closing.contact.tip = tip;
      closing.contact.origin = ContactOrigin::auto_closed;
      closing.contact.point = target_from_base * separation.on_second;
      closing.contact.normal = -(target_from_base.linear() * separation.normal);
      const Pose& base_from_tip_frame = probe.scratch.base_from_frame[robot.tips[tip].frame];
      closing.contact.centre = target_from_base * (base_from_tip_frame * robot.pads[tip].centre);
      closing.turn = touching - q;
      q = touching;
      return closing;
    }
    bool stopped = false;
    for (const int c : probe.finger_capsules) {
      if (c == pad_capsule || probe.separation_from_target(c).distance > 0) continue;
      stopped |= stop_before(c) > 0;
    }
    if (!stopped) posture = next;
  }
  reason = "its inner links touch the target before the pad";
  return std::nullopt;
}

}  // namespace

FingerClosures close_fingers(const collision::CollisionWorld& world, double time_s,
                             const std::vector<std::size_t>& tips, JointVector q) {
  FingerClosures closed;
  if (world.target < 0) return closed;
  const robot::Robot& robot = *world.robot;
  const SceneObject& target = world.scene->objects[world.target];
  for (const std::size_t tip : tips) {
    if (robot.pads[tip].capsule < 0) continue;
    Probe probe{world, capsules_of(robot, tip), {}, recorded_pose(target, time_s), {}};
    for (const std::size_t other : tips) {
      const auto is_other = [&](const FingerClosure& known) { return known.contact.tip == other; };
      if (other == tip || std::ranges::any_of(closed.closings, is_other)) continue;
      const std::vector<int> capsules = capsules_of(robot, other);
      probe.ignored_capsules.insert(probe.ignored_capsules.end(), capsules.begin(), capsules.end());
    }
    std::optional<FingerClosure> closing;
    std::string reason;  // that of the smallest abduction
    for (const double angle : {0.0, kAbductionStep_rad, -kAbductionStep_rad, 2 * kAbductionStep_rad,
                               -2 * kAbductionStep_rad}) {
      std::string attempt_reason;
      closing = close_finger(probe, time_s, tip, angle, q, attempt_reason);
      if (closing) break;
      if (reason.empty()) reason = attempt_reason;
    }
    if (closing) {
      closed.closings.push_back(std::move(*closing));
    } else {
      closed.open_reasons.push_back(robot.tips[tip].name + " stays open: " + reason);
    }
  }
  return closed;
}

std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldInterval& hold) {
  std::vector<std::size_t> tips;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    if (robot.tips[tip].finger < 0 || robot.pads[tip].capsule < 0) continue;
    bool has_goal = false;
    for (int f = 0; f < std::ssize(goals.time); ++f) {
      const bool held = goals.time[f] >= hold.begin_s && goals.time[f] <= hold.end_s;
      has_goal = has_goal || (held && is_known(goals.tip_position(f, tip)));
    }
    if (!has_goal) tips.push_back(tip);
  }
  return tips;
}

void set_closure_goals(const robot::Robot& robot, const std::vector<FingerClosure>& closings,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals) {
  if (closings.empty()) return;
  const HoldInterval hold = hold_interval(movement);
  if (goals.tip_to_pad_share.rows == 0)
    goals.tip_to_pad_share = {goals.frames(), robot.tips.size(), 0.0};
  std::vector<Pose> base_from_frame;
  for (int f = 0; f < std::ssize(goals.time); ++f) {
    const double share = closing_progress(hold, goals.time[f]);
    if (share == 0) continue;
    JointVector q = path.row(f).transpose();
    for (const FingerClosure& closing : closings) q += share * closing.turn;
    robot::forward_kinematics(robot, q.cwiseMax(robot.lower).cwiseMin(robot.upper),
                              base_from_frame);
    const bool in_palm = goals.time[f] > target.attach_s && !target.attached_frame.empty();
    for (const FingerClosure& closing : closings) {
      const std::size_t tip = closing.contact.tip;
      goals.tip_position(f, tip) =
          share < 1 || in_palm ? robot::tracked_point(robot, base_from_frame, tip, 1)
                               : recorded_pose(target, goals.time[f]) * closing.contact.centre;
      goals.tip_to_pad_share(f, tip) = 1;
    }
  }
  goals.auto_closed.assign(robot.tips.size(), 0);
  for (const FingerClosure& closing : closings) goals.auto_closed[closing.contact.tip] = 1;
}

}  // namespace morphe::grasp
