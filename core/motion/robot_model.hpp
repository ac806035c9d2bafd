#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/motion/export.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/side.hpp"

namespace morphe {

/// A robot as stored in plans.h5, with all data for kinematics, limits and contacts. The pose of a
/// frame is base_from_frame = base_from_parent * transform * M. M is Rotation(axis, value), or
/// Translation(axis * value) if prismatic, with value = ratio * position[joint] + offset, or the
/// identity if joint = -1. Parents precede their children. A joint's unit is rad if the first of
/// its frames is revolute, else m; for its other frames, ratio and offset convert it.
struct RobotModel {
  static constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  /// A link frame with its parent and the joint between them.
  struct Frame {
    std::string name;
    int parent = -1;  ///< -1 = base
    Pose transform = Pose::Identity();
    Vec3 axis = Vec3::UnitZ();
    int joint = -1;
    double ratio = 1, offset = 0;
    bool prismatic = false;
  };
  /// The limits of a frame that is coupled to a joint, in terms of its own value and its
  /// derivatives; infinite if not bounded. The joint limits below satisfy them.
  struct CoupledLimit {
    int frame = 0;
    double lower = -kUnbounded, upper = kUnbounded;
    double velocity = kUnbounded, acceleration = kUnbounded, jerk = kUnbounded;
  };
  /// A limit of a joint's velocity near the ends of its range, in addition to `velocity`:
  ///   v <= max(0, sqrt(twice_deceleration * (upper_end - q)) - velocity_offset),
  ///  -v <= max(0, sqrt(twice_deceleration * (q - lower_end)) - velocity_offset),
  /// in which a negative product counts as 0.
  struct BrakingCurve {
    int joint = 0;
    double twice_deceleration = 0;        ///< [rad/s^2]
    double velocity_offset = 0;           ///< [rad/s]
    double lower_end = 0, upper_end = 0;  ///< [rad]
  };
  /// A fingertip, or the wrist, that has goals.
  struct Tip {
    std::string name;
    int frame = 0;
    Pose transform = Pose::Identity();  ///< frame_from_tip
    int finger = 0;                     ///< 0 thumb … 4 little, -1 the wrist
    /// For a hand without five fingers: the parameter, 0 … 1, of the point that the tip follows on
    /// the curve through the person's index to little tips; `finger` is the nearest of them.
    double finger_curve_share = kUnknown;
  };
  /// A joint centre of humanlikeness metric A.
  struct JointCentre {
    int frame = 0;
    std::string chain;  ///< "arm" or a finger's name
  };
  /// A capsule of a link's collision geometry.
  struct Capsule {
    std::string name;
    int frame = -1;  ///< -1 = base
    Vec3 from = Vec3::Zero(), to = Vec3::Zero();
    double radius = 0;
    bool may_touch_target = false;
  };

  std::string name;
  std::vector<std::string> joint_names;      ///< [n] actuated, in the order of position arrays
  JointVector lower, upper;                  ///< [n] [rad or m]
  JointVector velocity, acceleration, jerk;  ///< [n] per s, s^2, s^3, all > 0
  std::vector<CoupledLimit> coupled_limits;
  std::vector<BrakingCurve> braking_curves;
  std::vector<Frame> frames;
  std::vector<Tip> tips;
  std::vector<JointCentre> joint_centres;  ///< the first one of the arm is the elbow
  std::vector<Capsule> capsules;
  std::vector<std::array<int, 2>> allowed_collision_pairs;  ///< capsules i < j, not checked
  std::vector<std::string> unchecked_links;  ///< with geometry, but without a capsule
  int shoulder_frame = 0;                    ///< frame whose origin is the robot's shoulder
  /// The frame that carries the hand: z to the fingers, x out of the palm, y to the thumb of a
  /// right hand, or away from the thumb of a left one.
  int palm_frame = 0;
  Side side = Side::right;  ///< side of the hand; recordings of the other side are mirrored

  /// Returns the number of actuated joints.
  std::size_t joints() const { return joint_names.size(); }
  /// Returns true if some frame is prismatic.
  bool has_prismatic_joint() const { return std::ranges::any_of(frames, &Frame::prismatic); }
};

/// Returns a sentence that lists the links that are not checked for contact, "" without any.
MORPHE_EXPORT std::string unchecked_sentence(const std::vector<std::string>& links);

}  // namespace morphe
