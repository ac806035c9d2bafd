#include "stages/map/placement.hpp"

#include <cmath>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/map/finger_curve.hpp"

namespace morphe::map {
namespace {

Vec3 point_on_curve(const Array2D<Vec3>& fingers, std::size_t row, double along) {
  return finger_curve_point({fingers(row, 1), fingers(row, 2), fingers(row, 3), fingers(row, 4)},
                            along);
}

Vec3 axis_of(const std::string& name) {
  return name == "x" ? Vec3::UnitX() : name == "y" ? Vec3::UnitY() : Vec3::UnitZ();
}

bool contains_time(const Movement& movement, double time_s) {
  constexpr double kTimeTolerance_s = 1e-9;
  return time_s >= movement.begin_s - kTimeTolerance_s &&
         time_s <= movement.end_s + kTimeTolerance_s;
}

}  // namespace

std::string validation_error(const PlacementOptions& options) {
  for (const auto& turn : options.rotation) {
    if (turn.axis != "x" && turn.axis != "y" && turn.axis != "z") {
      return "rotation: axis must be x, y or z, not '" + turn.axis + "'";
    }
  }
  return "";
}

Eigen::Matrix3d rotation_of(const PlacementOptions& options) {
  Pose pose = Pose::Identity();
  for (const auto& turn : options.rotation)
    pose.rotate(Eigen::AngleAxisd(turn.angle, axis_of(turn.axis)));
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
  for (const RobotModel::JointCentre& centre : robot.joint_centres) {
    if (centre.chain == "arm") return false;
  }
  int joints = 0;
  for (const int frame : robot::ancestors(robot, robot.palm_frame)) {
    joints += robot::joint_of(robot, frame) >= 0 ? 1 : 0;
  }
  return joints <= 2;
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
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    if (contains_time(movement, motion.time[i]) && is_known(motion.shoulder[i]))
      return motion.shoulder[i];
  }
  return unknown_point();
}

Goals make_goals(const RobotModel& robot, const HumanMotion& motion, const Movement& movement,
                 const Pose& base_from_world) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
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
  const auto turned = [&](const Quat& rotation) -> Quat {
    return is_known(rotation) ? Quat((base_from_world_rotation * rotation).normalized()) : rotation;
  };
  for (std::size_t f = 0; f < rows.size(); ++f) {
    const std::size_t row = rows[f];
    goals.time.push_back(motion.time[row]);
    goals.shoulder_position.push_back(in_common_base(motion.shoulder[row]));
    goals.elbow_position.push_back(in_common_base(motion.elbow[row]));
    goals.wrist_position.push_back(in_common_base(motion.wrist[row]));
    goals.wrist_orientation.push_back(turned(motion.wrist_orientation[row]));
    for (std::size_t i = 0; i < robot.tips.size(); ++i) {
      const int finger = robot.tips[i].finger;
      if (finger < 0) {
        goals.tip_position(f, i) = base_from_world * motion.wrist[row];
        goals.tip_orientation(f, i) = turned(motion.wrist_orientation[row]);
        continue;
      }
      const double along = robot.tips[i].finger_curve_share;
      if (std::isfinite(along)) {
        goals.tip_position(f, i) = base_from_world * point_on_curve(motion.tip, row, along);
        continue;
      }
      const auto human = static_cast<std::size_t>(finger);
      goals.tip_position(f, i) = base_from_world * motion.tip(row, human);
      goals.tip_orientation(f, i) = turned(motion.tip_orientation(row, human));
    }
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      goals.finger_joint_position(f, finger) = in_common_base(motion.finger_joint(row, finger));
    }
  }
  return goals;
}

}  // namespace morphe::map
