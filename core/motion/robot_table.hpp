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

/// A robot as plans.h5 stores it: all that is needed for kinematics, limits and contacts.
/// Frame pose: base_from_frame = base_from_parent * transform * Rotation(axis, value), or
/// Translation(axis * value) if it slides, with value = ratio * position[joint] + offset (joint =
/// -1: fixed, neither). Parents first. A joint is measured in rad if the first of its frames turns,
/// in m if that slides; ratio and offset convert.
struct RobotTable {
  static constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  struct Frame {
    std::string name;
    int parent = -1;  ///< -1 = base
    Pose transform = Pose::Identity();
    Vec3 axis = Vec3::UnitZ();
    int joint = -1;
    double ratio = 1, offset = 0;
    bool slides = false;
  };
  /// What a frame that is coupled to a joint may do itself, by its own value and its derivatives;
  /// infinite: not bounded. The joint's limits below are within them.
  struct CoupledLimit {
    int frame = 0;
    double lower = -kUnbounded, upper = kUnbounded;
    double velocity = kUnbounded, acceleration = kUnbounded, jerk = kUnbounded;
  };
  /// A joint's velocity towards its ends, beside `velocity`:
  ///   v <= max(0, sqrt(slope * (upper_end - q)) - drop),
  ///  -v <= max(0, sqrt(slope * (q - lower_end)) - drop)   (a negative product counts as 0)
  struct BrakingCurve {
    int joint = 0;
    double slope = 0;                     ///< twice the deceleration [rad/s^2]
    double drop = 0;                      ///< [rad/s]
    double lower_end = 0, upper_end = 0;  ///< [rad]
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
  JointVector lower, upper;              ///< [n] [rad or m]
  JointVector velocity, acceleration, jerk;  ///< [n] per s, s^2, s^3, all > 0
  std::vector<CoupledLimit> coupled_limits;
  std::vector<BrakingCurve> braking_curves;
  std::vector<Frame> frames;
  std::vector<Tip> tips;
  std::vector<Centre> centres;  ///< joint centres of metric A; the arm's first one is the elbow
  std::vector<Capsule> capsules;
  std::vector<std::array<int, 2>> allowed_pairs;  ///< capsules that never count as colliding, i < j
  /// Links that have a body but no capsule: nothing of them is checked for contact.
  std::vector<std::string> unchecked_links;
  int shoulder_frame = 0;  ///< its origin is the robot's shoulder
  /// Carries the hand: z to the fingers, x out of the palm; y to the thumb of a right hand, away
  /// from that of a left one.
  int palm_frame = 0;
  Side side = Side::right;  ///< of the hand: what it follows is mirrored into a hand of its side

  std::size_t joints() const { return joint_names.size(); }
  bool some_slide() const { return std::ranges::any_of(frames, &Frame::slides); }
};

/// "", or which links are not checked for contact.
MORPHE_EXPORT std::string unchecked_sentence(const std::vector<std::string>& links);

}  // namespace morphe
