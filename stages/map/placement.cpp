#include "stages/map/placement.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/standing.hpp"
#include "core/robot/tree.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/finger_curve.hpp"

namespace morphe::map {
namespace {

Vec3 axis_of(const std::string& name) {
  return name == "x" ? Vec3::UnitX() : name == "y" ? Vec3::UnitY() : Vec3::UnitZ();
}

bool contains_time(const Movement& movement, double time_s) {
  constexpr double kRounding_s = 1e-9;
  return time_s >= movement.begin_s - kRounding_s && time_s <= movement.end_s + kRounding_s;
}

}  // namespace

std::string validation_error(const PlacementOptions& options) {
  for (const auto& [axis, angle] : options.rotation) {
    if (axis != "x" && axis != "y" && axis != "z") {
      return "rotation: axis must be x, y or z, not '" + axis + "'";
    }
  }
  return "";
}

Eigen::Matrix3d rotation_of(const PlacementOptions& options) {
  Pose pose = Pose::Identity();
  for (const auto& [axis, angle] : options.rotation)
    pose.rotate(Eigen::AngleAxisd(angle, axis_of(axis)));
  return pose.linear();
}

Vec3 robot_shoulder(const RobotModel& robot) {
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, JointVector::Zero(robot.joints()), base_from_frame);
  return base_from_frame[robot.shoulder_frame].translation();
}

Pose place_robot(const RobotModel& robot, const Vec3& human_shoulder,
                 const PlacementOptions& options) {
  Pose world_from_base = Pose::Identity();
  world_from_base.linear() = rotation_of(options);
  world_from_base.translation() =
      human_shoulder + options.shoulder_offset - world_from_base.linear() * robot_shoulder(robot);
  return world_from_base;
}

bool is_hand_only(const RobotModel& robot) {
  int joints = 0;
  for (const int frame : robot::ancestors(robot, robot.palm_frame)) {
    joints += robot::joint_of(robot, frame) >= 0 ? 1 : 0;
  }
  return joints <= kMaxWristJoints &&
         std::ranges::find(robot.joint_centres, "arm", &RobotModel::JointCentre::chain) ==
             robot.joint_centres.end();
}

std::string standing_text(const RobotModel& robot, const PlacementOptions& options) {
  if (is_hand_only(robot)) return "";
  return robot::standing_words(robot::standing_of(robot), Quat(rotation_of(options)));
}

Pose place_hand(const RobotModel& robot, const PlacementOptions& options) {
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, JointVector::Zero(robot.joints()), base_from_frame);
  Pose hand_from_palm = Pose::Identity();
  hand_from_palm.linear() = rotation_of(options);
  hand_from_palm.translation() = options.shoulder_offset;
  return hand_from_palm * base_from_frame[robot.palm_frame].inverse();
}

Vec3 shoulder_at_begin(const HumanMotion& motion, const Movement& movement) {
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    const Vec3& shoulder = motion.shoulder[i];
    if (contains_time(movement, motion.time[i]) && is_known(shoulder)) return shoulder;
  }
  return unknown_point();
}

Goals make_goals(const RobotModel& robot, const HumanMotion& motion, const Movement& movement,
                 const Pose& base_from_world) {
  std::vector<int> rows;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    if (contains_time(movement, motion.time[i])) rows.push_back(i);
  }
  Goals goals;
  goals.estimated = motion.estimated;
  goals.hand_scale = motion.hand_scale;
  goals.tip_position = {rows.size(), robot.tips.size(), unknown_point()};
  goals.tip_orientation = {rows.size(), robot.tips.size(), unknown_rotation()};
  goals.reachable = {rows.size(), robot.tips.size(), 1};
  goals.finger_joint_position = {rows.size(), kFingerCount, unknown_point()};
  if (!is_hand_only(robot)) {
    goals.common_base_offset =
        robot_shoulder(robot) - base_from_world * shoulder_at_begin(motion, movement);
  }
  const Quat base_from_world_rotation(base_from_world.linear());
  const auto in_common_base = [&](const Vec3& point) -> Vec3 {
    return base_from_world * point + goals.common_base_offset;
  };
  const auto in_base = [&](const Quat& rotation) -> Quat {
    return is_known(rotation) ? Quat((base_from_world_rotation * rotation).normalized()) : rotation;
  };
  for (int f = 0; f < std::ssize(rows); ++f) {
    const int row = rows[f];
    goals.time.push_back(motion.time[row]);
    goals.shoulder_position.push_back(in_common_base(motion.shoulder[row]));
    goals.elbow_position.push_back(in_common_base(motion.elbow[row]));
    goals.wrist_position.push_back(in_common_base(motion.wrist[row]));
    goals.wrist_orientation.push_back(in_base(motion.wrist_orientation[row]));
    for (int i = 0; i < std::ssize(robot.tips); ++i) {
      const int finger = robot.tips[i].finger;
      const double share = robot.tips[i].finger_curve_share;
      const auto tip = [&](int k) { return motion.tip(row, k); };
      if (finger < 0) {
        goals.tip_position(f, i) = base_from_world * motion.wrist[row];
        goals.tip_orientation(f, i) = goals.wrist_orientation.back();
      } else if (std::isfinite(share)) {
        goals.tip_position(f, i) =
            base_from_world * finger_curve_point({tip(1), tip(2), tip(3), tip(4)}, share);
      } else {
        goals.tip_position(f, i) = base_from_world * motion.tip(row, finger);
        goals.tip_orientation(f, i) = in_base(motion.tip_orientation(row, finger));
      }
    }
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      goals.finger_joint_position(f, finger) = in_common_base(motion.finger_joint(row, finger));
    }
  }
  return goals;
}

}  // namespace morphe::map
