#pragma once

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::certify {

/// Two links in the plane z = 0, upper arm 0.3 m and forearm 0.25 m, both turning about z; thumb
/// and index tips are 0.04 m beside the end of the forearm, the index on a joint of its own.
inline RobotModel planar_arm() {
  RobotModel robot;
  robot.name = "planar";
  robot.joint_names = {"shoulder", "elbow", "index"};
  robot.lower = JointVector::Constant(3, -2);
  robot.upper = JointVector::Constant(3, 2);
  robot.velocity = JointVector::Constant(3, 1);
  robot.acceleration = JointVector::Constant(3, 5);
  robot.jerk = JointVector::Constant(3, 60);
  const auto at = [](double x, double y) { return Pose(Eigen::Translation3d(x, y, 0)); };
  robot.frames = {{"upper_arm", -1, at(0, 0), Vec3::UnitZ(), 0, 1, 0},
                  {"forearm", 0, at(0.3, 0), Vec3::UnitZ(), 1, 1, 0},
                  {"index", 1, at(0.25, 0), Vec3::UnitZ(), 2, 1, 0}};
  robot.tips = {{"thumb_tip", 1, at(0.25, 0.04), 0}, {"index_tip", 2, at(0, -0.04), 1}};
  robot.joint_centres = {{1, "arm"}, {2, "index"}};
  robot.capsules = {{"upper_arm", 0, Vec3(0.05, 0, 0), Vec3(0.2, 0, 0), 0.03, false},
                    {"forearm", 1, Vec3(0.05, 0, 0), Vec3(0.25, 0, 0), 0.03, false}};
  robot.allowed_collision_pairs = {{0, 1}};
  robot.shoulder_frame = 0;
  robot.palm_frame = 1;
  return robot;
}

/// Two samples, rest to rest in 1 s, the shoulder from 0 to `angle`.
inline Trajectory sweep(double angle) {
  Trajectory t;
  t.time = t.demonstration_time = {0, 1};
  t.position = t.velocity = t.acceleration = JointRows::Zero(2, 3);
  t.position(1, 0) = angle;
  t.phase = {PhaseKind::reach, PhaseKind::reach};
  t.origin = {SampleOrigin::mapped, SampleOrigin::mapped};
  t.clearance = {kUnknown, kUnknown};
  return t;
}

inline SceneObject ball(const Vec3& at, double radius) {
  SceneObject object;
  object.name = "ball";
  object.shape = Shape::sphere;
  object.size = {radius};
  object.time = {0};
  object.position = {at};
  object.orientation = {Quat::Identity()};
  return object;
}

}  // namespace morphe::certify
