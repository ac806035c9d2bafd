#pragma once

#include <string>

#include "core/motion/robot_model.hpp"
#include "core/motion/scene.hpp"
#include "tests/core/collision/random_bodies.hpp"

namespace morphe::collision {

/// An arm of four joints, a fixed palm and two fingers of three joints, the last one coupled to the
/// middle one. Random links, axes and capsules. 4 + 2 * 2 = 8 actuated joints.
inline RobotModel random_robot(RandomBodies& random) {
  RobotModel robot;
  const auto add_frame = [&](int parent, double link_m, int joint, double ratio) {
    RobotModel::Frame frame;
    frame.parent = parent;
    frame.transform = random.pose(0);
    frame.transform.translation() = link_m * random.direction();
    frame.axis = random.direction();
    frame.joint = joint;
    frame.ratio = ratio;
    frame.offset = random.uniform(-1, 1);
    robot.frames.push_back(frame);
    return static_cast<int>(robot.frames.size()) - 1;
  };
  const auto add_capsule = [&](int frame, double length_m, double radius, bool touches) {
    const Vec3 from = 0.3 * length_m * random.direction();
    robot.capsules.push_back({"part" + std::to_string(robot.capsules.size()), frame, from,
                              from + length_m * random.direction(), radius, touches});
  };
  int frame = -1;
  add_capsule(frame, 0.1, 0.08, false);
  for (int joint = 0; joint < 4; ++joint) {
    frame = add_frame(frame, 0.25, joint, 1);
    add_capsule(frame, 0.2, 0.04, false);
  }
  const int palm = add_frame(frame, 0.1, -1, 1);
  add_capsule(palm, 0.05, 0.03, true);
  for (int finger = 0; finger < 2; ++finger) {
    const int joint = 4 + 2 * finger;
    frame = add_frame(palm, 0.06, joint, 1);
    add_capsule(frame, 0.03, 0.01, true);
    frame = add_frame(frame, 0.04, joint + 1, 1);
    add_capsule(frame, 0.03, 0.01, true);
    frame = add_frame(frame, 0.03, joint + 1, -0.7);
    add_capsule(frame, 0.02, 0.01, true);
  }
  for (int joint = 0; joint < 8; ++joint) robot.joint_names.push_back("j" + std::to_string(joint));
  robot.lower = JointVector::Constant(8, -3);
  robot.upper = JointVector::Constant(8, 3);
  for (int c = 0; c + 1 < static_cast<int>(robot.capsules.size()); ++c) {
    robot.allowed_collision_pairs.push_back({c, c + 1});
  }
  return robot;
}

/// The same with a palm of 25 capsules, a link of 11 in each finger, and one capsule more in the
/// base: several clusters of a frame, whose capsules are not next to each other in the list.
inline RobotModel random_robot_of_clusters(RandomBodies& random) {
  RobotModel robot = random_robot(random);
  const auto add = [&](int capsule, int count) {
    for (int k = 0; k < count; ++k) {
      RobotModel::Capsule copy = robot.capsules[static_cast<std::size_t>(capsule)];
      copy.name = "part" + std::to_string(robot.capsules.size());
      for (Vec3* end : {&copy.from, &copy.to}) *end += 0.04 * random.direction();
      copy.radius *= 0.5;
      robot.capsules.push_back(copy);
    }
  };
  for (int k = 0; k < 2; ++k) {
    add(5, 12);
    add(6 + 3 * k, 10);
  }
  add(0, 1);
  return robot;
}

inline JointVector random_position(RandomBodies& random, Eigen::Index joints, double reach) {
  JointVector q(joints);
  for (double& value : q) value = random.uniform(-reach, reach);
  return q;
}

/// One object of each shape about the robot; "cup", the sphere, moves and turns over [0, 1] s.
inline Scene random_scene(RandomBodies& random) {
  Scene scene;
  for (const Shape shape : kSolids) {
    SceneObject object = random.solid(shape);
    for (double& size : object.size) size *= 0.5;
    object.position = {0.7 * random.direction()};
    object.orientation = {Quat(random.pose(0).linear())};
    scene.objects.push_back(object);
  }
  SceneObject& cup = scene.objects.emplace_back(random.solid(Shape::box));
  cup.name = "cup";
  for (double& size : cup.size) size *= 0.3;
  cup.time = {0.1, 0.4, 0.8};
  cup.position = {random.point(0.5), random.point(0.5), random.point(0.5)};
  cup.orientation = {Quat(random.pose(0).linear()), Quat(random.pose(0).linear()),
                     Quat(random.pose(0).linear())};
  return scene;
}

}  // namespace morphe::collision
