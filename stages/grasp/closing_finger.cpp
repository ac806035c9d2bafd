#include "stages/grasp/closing_finger.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"

namespace morphe::grasp {
namespace {

bool contains(const std::vector<int>& list, int value) {
  return std::ranges::find(list, value) != list.end();
}

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

void FingerProbe::pose(const JointVector& q, double time_s) {
  collision::update_bodies(world, q, time_s, scratch);
}

collision::Separation FingerProbe::separation_from_target(int capsule) const {
  return collision::capsule_solid(scratch.bodies[capsule], collision::solid_at(world, world.target),
                                  base_from_target);
}

std::string FingerProbe::find_obstacle() const {
  const double margin = world.tolerances.required_clearance;
  for (const auto& [first, second] : pairs) {
    const auto& sphere = scratch.bounding_spheres[first];
    const auto& other_sphere = scratch.bounding_spheres[second];
    const double separated = margin + sphere.radius + other_sphere.radius;
    if ((sphere.centre - other_sphere.centre).squaredNorm() >= separated * separated) continue;
    if (collision::capsule_capsule(scratch.bodies[first], scratch.bodies[second]).distance >=
        margin)
      continue;
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

/// Returns the number of frames from the base to the tip that a joint moves: more, the farther
/// inside it is.
int moved_frame_count(const robot::Robot& robot, int joint, std::size_t tip) {
  int count = 0;
  for (const int frame : robot::ancestors(robot, robot.tips[tip].frame))
    count += robot::joint_moves_frame(robot, joint, frame) ? 1 : 0;
  return count;
}

/// Returns closing_joints(), the innermost first, each with its rate.
std::vector<std::pair<int, double>> joint_rates(const robot::Robot& robot, const JointVector& q,
                                                std::size_t tip, double curl) {
  std::vector<std::pair<int, double>> joints = closing_joints(robot, q, tip);
  std::ranges::stable_sort(joints, [&](const auto& a, const auto& b) {
    return moved_frame_count(robot, a.first, tip) > moved_frame_count(robot, b.first, tip);
  });
  const double last = static_cast<double>(joints.size()) - 1;
  for (std::size_t k = 0; k < joints.size() && last > 0; ++k)
    joints[k].second *= 1 + curl * (2 * static_cast<double>(k) / last - 1);
  return joints;
}

/// One finger as it closes.
class ClosingFinger {
 public:
  ClosingFinger(FingerProbe& probe, double time_s, std::size_t tip, double curl,
                const JointVector& open)
      : probe_(probe),
        robot_(*probe.world.robot),
        time_s_(time_s),
        tip_(tip),
        pad_(robot_.pads[tip].capsule),
        joints_(joint_rates(robot_, open, tip, curl)),
        posture_(open) {
    probe_.pose(posture_, time_s_);
  }

  /// Closes the finger; the turn is that from q. See close_finger().
  std::optional<FingerClosure> run(const JointVector& q, std::string& reason) {
    if (!open_until_outside()) {
      reason = "it is already inside the target";
      return std::nullopt;
    }
    while (!joints_.empty()) {
      const JointVector next = step(posture_, kClosingStep_rad);
      if (next == posture_) {
        reason = "it does not reach the target within its limits";
        return std::nullopt;
      }
      probe_.pose(next, time_s_);
      if (const std::string obstacle = probe_.find_obstacle(); !obstacle.empty()) {
        reason = "it would collide with " + obstacle;
        return std::nullopt;
      }
      if (gap() <= 0) return closure_at(touch_before(next) - q);
      if (!stop_at_touching_links()) posture_ = next;
    }
    reason = "its inner links touch the target before the pad";
    return std::nullopt;
  }

 private:
  double gap() const { return probe_.separation_from_target(pad_).distance; }

  JointVector step(const JointVector& from, double angle) const {
    JointVector to = from;
    for (const auto& [joint, rate] : joints_) {
      to[joint] = std::clamp(from[joint] + rate * angle, robot_.lower[joint], robot_.upper[joint]);
    }
    return to;
  }

  bool open_until_outside() {
    for (double opened = 0; gap() < 0; opened += kClosingStep_rad) {
      const JointVector open = step(posture_, -kClosingStep_rad);
      if (opened > kMaxOpening_rad || open == posture_) return false;
      posture_ = open;
      probe_.pose(posture_, time_s_);
    }
    return true;
  }

  /// Returns the posture between the last one and `next` in which the pad touches.
  JointVector touch_before(const JointVector& next) {
    double low = 0, high = 1;  // bounds of the bisection, as shares of the step
    JointVector touching = next;
    for (double apart = gap(); apart < 0 || apart > kContactTolerance_m;) {
      const double share = 0.5 * (low + high);
      touching = posture_ + share * (next - posture_);
      probe_.pose(touching, time_s_);
      apart = gap();
      (apart > 0 ? low : high) = share;
      if (high - low < 1e-9) break;
    }
    return touching;
  }

  FingerClosure closure_at(JointVector turn) const {
    const collision::Separation separation = probe_.separation_from_target(pad_);
    const Pose target_from_base = probe_.base_from_target.inverse();
    const Pose& base_from_tip = probe_.scratch.base_from_frame[robot_.tips[tip_].frame];
    FingerClosure closing;
    closing.contact.tip = tip_;
    closing.contact.origin = ContactOrigin::auto_closed;
    closing.contact.point = target_from_base * separation.on_second;
    closing.contact.normal = -(target_from_base.linear() * separation.normal);
    closing.contact.centre = target_from_base * (base_from_tip * robot_.pads[tip_].centre);
    closing.pad_angle_rad =
        pad_angle(base_from_tip.linear() * robot_.pads[tip_].direction, -separation.normal);
    closing.turn = std::move(turn);
    return closing;
  }

  /// Stops the joints that move links which touch; returns true if there are any.
  bool stop_at_touching_links() {
    bool stopped = false;
    for (const int c : probe_.finger_capsules) {
      if (c == pad_ || probe_.separation_from_target(c).distance > 0) continue;
      stopped |= std::erase_if(joints_, [&](const auto& joint) {
                   return robot::joint_moves_frame(robot_, joint.first, robot_.capsules[c].frame);
                 }) > 0;
    }
    return stopped;
  }

  FingerProbe& probe_;
  const robot::Robot& robot_;
  double time_s_;
  std::size_t tip_;
  int pad_;                                     ///< capsule of the pad
  std::vector<std::pair<int, double>> joints_;  ///< that still turn, with their rates
  JointVector posture_;
};

}  // namespace

std::optional<FingerClosure> close_finger(FingerProbe& probe, double time_s, std::size_t tip,
                                          const ClosingManner& manner, const JointVector& q,
                                          std::string& reason) {
  const JointVector open = abduct_finger(*probe.world.robot, q, tip, manner.abduction_rad);
  return ClosingFinger(probe, time_s, tip, manner.curl, open).run(q, reason);
}

}  // namespace morphe::grasp
