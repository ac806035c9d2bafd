#include "stages/grasp/close_fingers.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::grasp {
namespace {

constexpr double kClosingStep_rad = 0.01;  ///< step of the closing joints [rad]
/// Largest opening of a finger that begins inside the target [rad].
constexpr double kMaxOpening_rad = 0.5;
constexpr double kAbductionStep_rad = 7 * kRadPerDegree;
constexpr double kContactTolerance_m = 1e-5;  ///< gap at which the pad touches [m]
/// Least lever of a closing joint, as a share of the strongest joint's lever.
constexpr double kMinLeverRatio = 0.2;

/// Returns the capsules that move with the finger of `tip` but not with the palm.
std::vector<int> capsules_of(const robot::Robot& robot, std::size_t tip) {
  std::vector<int> own;
  const int palm = robot::moving_frame_of(robot, robot.palm_frame);
  std::vector<int> links;
  for (const int frame : robot::ancestors(robot, robot.tips[tip].frame)) {
    if (robot::moving_frame_of(robot, frame) == palm) break;
    links.push_back(robot::moving_frame_of(robot, frame));
  }
  for (std::size_t c = 0; c < robot.capsules.size(); ++c) {
    const int body = robot::moving_frame_of(robot, robot.capsules[c].frame);
    if (std::ranges::find(links, body) != links.end()) own.push_back(static_cast<int>(c));
  }
  return own;
}

bool contains(const std::vector<int>& list, int value) {
  return std::ranges::find(list, value) != list.end();
}

/// Distance queries for one finger at one posture.
struct Probe {
  const collision::CollisionWorld& world;
  std::vector<int> own;
  /// Capsules of fingers not yet closed: the mapping moves them aside.
  std::vector<int> ignored_capsules;
  Pose base_from_target;
  collision::CollisionScratch scratch;

  void pose(const JointVector& q, double time_s) {
    collision::update_bodies(world, q, time_s, scratch);
  }
  collision::Separation separation_from_target(int capsule) const {
    return collision::capsule_solid(scratch.bodies[capsule],
                                    collision::solid_at(world, world.target), base_from_target);
  }
  /// Returns the name of a body other than the target that is nearer to the finger than the margin;
  /// "" if there is no such body.
  std::string find_obstacle() const {
    const double margin = world.tolerances.required_clearance;
    for (const auto& [first, second] : world.pairs) {
      if (contains(own, first) == contains(own, second)) continue;
      if (contains(ignored_capsules, first) || contains(ignored_capsules, second)) continue;
      const auto body = [&](int c) { return scratch.bodies[c]; };
      if (collision::capsule_capsule(body(first), body(second)).distance >= margin) continue;
      const int other = contains(own, first) ? second : first;
      return world.robot->capsules[other].name;
    }
    for (std::size_t k = 0; k < world.scene->objects.size(); ++k) {
      if (static_cast<int>(k) == world.target) continue;
      for (const int c : own) {
        const auto apart = collision::capsule_solid(
            scratch.bodies[c], collision::solid_at(world, k), scratch.object_poses[k]);
        if (apart.distance < margin) return world.scene->objects[k].name;
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
  const Eigen::RowVectorXd forwards = (pose.linear() * pad.direction).transpose() * jacobian;
  std::vector<std::pair<int, double>> joints;
  double strongest = 0;
  const auto of_finger = [&](int j) { return !contains(robot.arm_joints, j); };
  for (int j = 0; j < static_cast<int>(q.size()); ++j) {
    if (of_finger(j)) strongest = std::max(strongest, std::abs(forwards[j]));
  }
  for (int j = 0; j < static_cast<int>(q.size()); ++j) {
    if (!of_finger(j) || std::abs(forwards[j]) <= kMinLeverRatio * strongest) continue;
    joints.emplace_back(j, forwards[j] > 0 ? 1.0 : -1.0);
  }
  return joints;
}

namespace {

/// Returns q with the finger's joints that do not close it turned by `angle`.
JointVector abduct_finger(const robot::Robot& robot, const JointVector& q, std::size_t tip,
                          double angle) {
  const std::vector<std::pair<int, double>> closing = closing_joints(robot, q, tip);
  JointVector aside = q;
  for (int j = 0; j < static_cast<int>(q.size()); ++j) {
    const bool closes =
        std::ranges::any_of(closing, [&](const auto& joint) { return joint.first == j; });
    if (closes || contains(robot.arm_joints, j)) continue;
    if (!robot::joint_moves_frame(robot, j, robot.tips[tip].frame)) continue;
    aside[j] = std::clamp(q[j] + angle, robot.lower[j], robot.upper[j]);
  }
  return aside;
}

/// Closes one finger, abducted by `angle`. If it touches, q is set to the touching posture;
/// otherwise q is unchanged and `why` gives the reason.
std::optional<FingerClosure> close_finger(Probe& probe, double time_s, std::size_t tip,
                                          double angle, JointVector& q, std::string& why) {
  const collision::CollisionWorld& world = probe.world;
  const robot::Robot& robot = *world.robot;
  const int pad_capsule = robot.pads[tip].capsule;
  JointVector at = abduct_finger(robot, q, tip, angle);
  std::vector<std::pair<int, double>> joints = closing_joints(robot, at, tip);
  const auto stop_before = [&](int capsule) {  // removes the joints that move the touching link
    const int frame = robot.capsules[capsule].frame;
    return std::erase_if(joints, [&](const auto& joint) {
      return robot::joint_moves_frame(robot, joint.first, frame);
    });
  };
  const auto turned = [&](const JointVector& from, double step) {
    JointVector to = from;
    for (const auto& [joint, sign] : joints) {
      to[joint] = std::clamp(from[joint] + sign * step, robot.lower[joint], robot.upper[joint]);
    }
    return to;
  };
  probe.pose(at, time_s);
  for (double opened = 0; probe.separation_from_target(pad_capsule).distance < 0;
       opened += kClosingStep_rad) {
    const JointVector open = turned(at, -kClosingStep_rad);
    if (opened > kMaxOpening_rad || open == at) {
      why = "it is already inside the target";
      return std::nullopt;
    }
    at = open;
    probe.pose(at, time_s);
  }
  while (!joints.empty()) {
    const JointVector next = turned(at, kClosingStep_rad);
    if (next == at) {
      why = "it does not reach the target within its limits";
      return std::nullopt;
    }
    probe.pose(next, time_s);
    if (const std::string what = probe.find_obstacle(); !what.empty()) {
      why = "it would collide with " + what;
      return std::nullopt;
    }
    double gap = probe.separation_from_target(pad_capsule).distance;
    if (gap <= 0) {
      double low = 0, high = 1;  // bounds of the bisection, as shares of the step
      JointVector between = next;
      while (gap < 0 || gap > kContactTolerance_m) {
        const double share = 0.5 * (low + high);
        between = at + share * (next - at);
        probe.pose(between, time_s);
        gap = probe.separation_from_target(pad_capsule).distance;
        (gap > 0 ? low : high) = share;
        if (high - low < 1e-9) break;
      }
      const collision::Separation apart = probe.separation_from_target(pad_capsule);
      const Pose target_from_base = probe.base_from_target.inverse();
      FingerClosure closing;
      closing.contact.tip = tip;
      closing.contact.origin = ContactOrigin::auto_closed;
      closing.contact.point = target_from_base * apart.on_second;
      closing.contact.normal = -(target_from_base.linear() * apart.normal);
      const auto frame = static_cast<std::size_t>(robot.tips[tip].frame);
      closing.contact.centre =
          target_from_base * (probe.scratch.base_from_frame[frame] * robot.pads[tip].centre);
      closing.turn = between - q;
      q = between;
      return closing;
    }
    bool stopped = false;
    for (const int c : probe.own) {
      if (c == pad_capsule || probe.separation_from_target(c).distance > 0) continue;
      stopped |= stop_before(c) > 0;
    }
    if (!stopped) at = next;
  }
  why = "its inner links touch the target before the pad";
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
      const bool is_closed = std::ranges::any_of(
          closed.closings, [&](const FingerClosure& known) { return known.contact.tip == other; });
      if (other == tip || is_closed) continue;
      const std::vector<int> capsules = capsules_of(robot, other);
      probe.ignored_capsules.insert(probe.ignored_capsules.end(), capsules.begin(), capsules.end());
    }
    std::optional<FingerClosure> closing;
    std::string why;  // reason at the smallest abduction
    for (const double angle : {0.0, kAbductionStep_rad, -kAbductionStep_rad, 2 * kAbductionStep_rad,
                               -2 * kAbductionStep_rad}) {
      std::string because;
      closing = close_finger(probe, time_s, tip, angle, q, because);
      if (closing) break;
      if (why.empty()) why = because;
    }
    if (closing) {
      closed.closings.push_back(std::move(*closing));
    } else {
      closed.open_reasons.push_back(robot.tips[tip].name + " stays open: " + why);
    }
  }
  return closed;
}

std::vector<std::size_t> tips_without_goals(const robot::Robot& robot, const Goals& goals,
                                            const HoldInterval& when) {
  std::vector<std::size_t> tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    if (robot.tips[tip].finger < 0 || robot.pads[tip].capsule < 0) continue;
    bool any = false;
    for (std::size_t f = 0; f < goals.frames(); ++f) {
      const bool held = goals.time[f] >= when.begin_s && goals.time[f] <= when.end_s;
      any = any || (held && is_known(goals.tip_position(f, tip)));
    }
    if (!any) tips.push_back(tip);
  }
  return tips;
}

void set_closure_goals(const robot::Robot& robot, const std::vector<FingerClosure>& closings,
                       const Movement& movement, const SceneObject& target, const JointRows& path,
                       Goals& goals) {
  if (closings.empty()) return;
  const HoldInterval when = hold_interval(movement);
  if (goals.tip_to_pad_share.rows == 0)
    goals.tip_to_pad_share = {goals.frames(), robot.tips.size(), 0.0};
  std::vector<Pose> base_from_frame;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    const double share = closing_progress(when, goals.time[f]);
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
