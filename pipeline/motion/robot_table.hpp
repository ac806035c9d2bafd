#pragma once

#include <array>
#include <string>
#include <vector>

#include "pipeline/motion/geometry.hpp"

namespace morphe {

/// A robot as plans.h5 stores it: all that is needed for kinematics, limits and contacts.
/// Frame pose: base_from_frame = base_from_parent * transform * Rotation(axis, angle) with
/// angle = ratio * position[joint] + offset (joint = -1: fixed, no rotation). Parents first.
struct RobotTable {
  struct Frame {
    std::string name;
    int parent = -1;  ///< -1 = base
    Pose transform = Pose::Identity();
    Vec3 axis = Vec3::UnitZ();
    int joint = -1;
    double ratio = 1, offset = 0;
  };
  struct Tip {
    std::string name;
    int frame = 0;
    Pose transform = Pose::Identity();  ///< frame_from_tip
    int finger = 0;                     ///< 0 thumb … 4 little, -1 the wrist
    /// Of a hand without five fingers: the tip follows the point at this share (0 … 1) of the curve
    /// through the human's index, middle, ring and little tips; `finger` is the nearest of them.
    double along = kNotSeen;
  };
  struct Centre {
    int frame = 0;
    std::string chain;  ///< "arm" or a finger's name
  };
  struct Capsule {
    std::string name;
    int frame = -1;  ///< -1 = base
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double radius = 0;
    bool may_touch_target = false;
  };

  std::string name;
  std::vector<std::string> joint_names;  ///< [n] actuated joints, the order of every position array
  JointVector lower, upper;              ///< [n] [rad]
  JointVector velocity, acceleration, jerk;  ///< [n] [rad/s], [rad/s^2], [rad/s^3], all > 0
  std::vector<Frame> frames;
  std::vector<Tip> tips;
  std::vector<Centre> centres;  ///< joint centres of metric A; the arm's first one is the elbow
  std::vector<Capsule> capsules;
  std::vector<std::array<int, 2>> allowed_pairs;  ///< capsules that never count as colliding, i < j
  int shoulder_frame = 0;                         ///< its origin is the robot's shoulder
  int palm_frame = 0;  ///< carries the hand: z to the fingers, y to the thumb, x out of the palm

  std::size_t joints() const { return joint_names.size(); }
};

}  // namespace morphe
