#pragma once

#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::map {

/// The placement of the robot relative to the human (config section `placement`): the paper's
/// common base frame. In each movement the human shoulder is fixed at its position at the start of
/// the movement.
struct PlacementOptions {
  /// A rotation about a coordinate axis.
  struct ElementaryRotation {
    std::string axis;  ///< x, y or z of the frame reached so far
    double angle = 0;  ///< [rad]
  };
  /// Orientation world_from_base as elementary rotations, multiplied from left to right.
  std::vector<ElementaryRotation> rotation;
  /// Offset from the human shoulder to the robot's, in the world frame (X right, Y forward, Z up)
  /// [m].
  Vec3 shoulder_offset = Vec3::Zero();
};
template <class Fields>
void fields(Fields& f, PlacementOptions::ElementaryRotation& o) {
  f.required("axis", o.axis);
  f.required("angle", o.angle);
}
template <class Fields>
void fields(Fields& f, PlacementOptions& o) {
  f("rotation", o.rotation);
  f("shoulder_offset", o.shoulder_offset);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const PlacementOptions& options);

/// Returns R, the product of the elementary rotations.
Eigen::Matrix3d rotation_of(const PlacementOptions& options);

/// Returns the robot's shoulder in the frame of its base, all joints at zero [m].
Vec3 robot_shoulder(const RobotModel& robot);

/// Returns world_from_base = Translation(t) * R, with R the product of the elementary rotations and
/// t such that world_from_base * (robot shoulder) = human shoulder + shoulder_offset.
Pose place_robot(const RobotModel& robot, const Vec3& human_shoulder,
                 const PlacementOptions& options);

/// Returns true if the robot has no arm: no joint centre belongs to one, and at most two joints (a
/// wrist's) move the palm.
bool is_hand_only(const RobotModel& robot);

/// Returns the corresponding pose for a hand alone, whose goals are in the human hand's own frame.
/// Its palm, all joints at zero, has the pose of the human's hand, rotated and shifted by the
/// options:
///   hand_from_base = Translation(shoulder_offset) * R * palm_from_base
Pose place_hand(const RobotModel& robot, const PlacementOptions& options);

/// Creates the goals of a movement's frames in the base frame; each of the robot's tips follows the
/// human finger that it names. The human arm is shifted so that its shoulder at the start of the
/// movement coincides with the robot's; a hand alone has no arm to shift.
Goals make_goals(const RobotModel& robot, const HumanMotion& motion, const Movement& movement,
                 const Pose& base_from_world);

/// Returns the shoulder in the first frame of the movement in which it was seen (or estimated);
/// unseen if there is no such frame.
Vec3 shoulder_at_begin(const HumanMotion& motion, const Movement& movement);

}  // namespace morphe::map
