#pragma once

#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::map {

/// Where the robot stands relative to the human (config section `placement`): the paper's common
/// base frame. Per movement the human shoulder is frozen where it is when the movement begins.
struct PlacementOptions {
  struct Turn {
    std::string axis;  ///< x, y or z of the frame reached so far
    double angle = 0;  ///< [rad]
  };
  /// world_from_base as elementary rotations, multiplied from left to right.
  std::vector<Turn> rotation;
  /// From the human shoulder to the robot's, in the world frame (X right, Y forward, Z up) [m].
  Vec3 shoulder_offset = Vec3::Zero();
};
template <class Fields>
void fields(Fields& f, PlacementOptions::Turn& o) {
  f.required("axis", o.axis);
  f.required("angle", o.angle);
}
template <class Fields>
void fields(Fields& f, PlacementOptions& o) {
  f("rotation", o.rotation);
  f("shoulder_offset", o.shoulder_offset);
}
std::string why_invalid(const PlacementOptions& options);

/// R: the product of the turns.
Eigen::Matrix3d rotation_of(const PlacementOptions& options);

/// The robot's shoulder in the frame of its base, all joints at zero [m].
Vec3 robot_shoulder(const RobotTable& robot);

/// world_from_base = Translation(t) * R with R the product of the turns and t such that
/// world_from_base * (robot shoulder) = human shoulder + shoulder_offset.
Pose place_robot(const RobotTable& robot, const Vec3& human_shoulder,
                 const PlacementOptions& options);

/// A robot without an arm: no joint centre belongs to one, and no more than two joints (a wrist's)
/// move the palm.
bool hand_alone(const RobotTable& robot);

/// The same for a hand alone, whose goals are in the human hand's own frame: its palm, all joints
/// at zero, stands where the human's hand is, turned and shifted as the options say.
///   hand_from_base = Translation(shoulder_offset) * R * palm_from_base
Pose place_hand(const RobotTable& robot, const PlacementOptions& options);

/// Goals of the frames of a movement, in the base frame, each of the robot's tips following the
/// human finger that it names. The human arm is shifted so that its shoulder at the begin of the
/// movement coincides with the robot's; a hand alone has no arm to shift.
Goals make_goals(const RobotTable& robot, const HumanMotion& motion, const Movement& movement,
                 const Pose& base_from_world);

/// First frame of the movement whose shoulder was seen (or estimated); unseen if there is none.
Vec3 shoulder_at_begin(const HumanMotion& motion, const Movement& movement);

}  // namespace morphe::map
