#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::map {

/// The command that found a placement.
enum class PlacementFinder { place };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 1> names_of(PlacementFinder) { return {"place"}; }

/// The placement of the robot relative to the human (config section `placement`): the paper's
/// common base frame. The human shoulder is taken from the beginning of the movement.
struct PlacementOptions {
  /// A rotation about a coordinate axis.
  struct ElementaryRotation {
    std::string axis;  ///< x, y or z, as the previous rotations have turned it
    double angle = 0;  ///< [rad]
  };
  std::vector<ElementaryRotation> rotation;  ///< world_from_base, multiplied from left to right
  Vec3 shoulder_offset = Vec3::Zero();  ///< from the human's to the robot's shoulder, in world [m]
  /// The command that found it: advice then does not name this command.
  std::optional<PlacementFinder> found_by;
};
template <class Fields>
void fields(Fields& f, PlacementOptions::ElementaryRotation& o) {
  f.required("axis", o.axis);
  f.required("angle", o.angle, bounds::kAngle);
}
template <class Fields>
void fields(Fields& f, PlacementOptions& o) {
  f("rotation", o.rotation);
  f("shoulder_offset", o.shoulder_offset, bounds::kCoordinate);
  f("found_by", o.found_by);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const PlacementOptions& options);

/// Returns the product of the elementary rotations, R.
Eigen::Matrix3d rotation_of(const PlacementOptions& options);

/// Returns the robot's shoulder in the frame of its base, all joints at zero [m].
Vec3 robot_shoulder(const RobotModel& robot);

/// Returns world_from_base = Translation(t) * R, with t such that
///   world_from_base * robot shoulder = human shoulder + shoulder_offset.
Pose place_robot(const RobotModel& robot, const Vec3& human_shoulder,
                 const PlacementOptions& options);

/// Returns true if the robot is a hand alone: it has no joint centre of an arm, and at most
/// kMaxWristJoints joints move its palm.
bool is_hand_only(const RobotModel& robot);

/// Returns how the base stands with this placement, in robot::standing_words(): "hangs, tilted by
/// 8 degrees from straight down"; "" for a hand alone, which has no base.
std::string standing_text(const RobotModel& robot, const PlacementOptions& options);

/// Returns the pose of the base of a hand alone, whose goals are in the human hand's own frame. Its
/// palm, all joints at zero, has the pose of the human's hand, rotated and shifted by the options:
///   hand_from_base = Translation(shoulder_offset) * R * palm_from_base
Pose place_hand(const RobotModel& robot, const PlacementOptions& options);

/// Creates the goals of a movement's frames in the base frame, all reachable until they are judged.
/// Each of the robot's tips follows the human finger that its description names. The human arm is
/// shifted so that its shoulder_at_begin() coincides with the robot's shoulder, unless the robot is
/// a hand alone.
Goals make_goals(const RobotModel& robot, const HumanMotion& motion, const Movement& movement,
                 const Pose& base_from_world);

/// Returns the first shoulder of the movement that was seen or estimated; unseen if there is none.
Vec3 shoulder_at_begin(const HumanMotion& motion, const Movement& movement);

}  // namespace morphe::map
