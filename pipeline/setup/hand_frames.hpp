#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// The pad of a finger: z along the last bone, x out of the pad, origin on the surface of the pad.
struct Pad {
  /// Last frame of the finger.
  int frame = -1;
  /// The pose of the pad in the frame.
  Pose frame_from_pad = Pose::Identity();
  /// Link of a tip in the file, "" if there is no such link.
  std::string urdf_tip_link;
  /// Position of that tip in the frame [m].
  Vec3 urdf_tip = Vec3::Zero();
  /// The certainty of the pose.
  Provenance sure = Provenance::assumed;
  /// True if the tip in the file is beyond the shapes of the finger.
  bool tip_beyond_shapes = false;
};

/// The distance beyond the end of the shapes above which the tip in the file is used instead [m].
inline constexpr double kMaxTipBeyondShapes_m = 0.01;
/// The maximum distance of the pad from the end of a finger [m], half of a human fingertip.
inline constexpr double kPadSetback_m = 0.008;
/// The distance from the surface of the pad to the axis of the finger, to which goals refer [m].
inline constexpr double kPadDepth_m = 0.010;

/// Finds the pads of a hand's fingers, in their order. With c the projection of the end onto the
/// axis of the last joint: bone = end - c, normal = (axis in the sense of closing) × bone, with the
/// end at the point of the body farthest along the bone. The end of a finger without shapes, or
/// with shapes that end before the tip in the file (a bracket without its rubber), is that tip;
/// without such a tip it is at twice the distance of its centre of mass. The pads of a gripper face
/// each other across the line between them.
std::vector<Pad> find_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points);

/// The palm frame: z towards the fingers, y to the side of the thumb and x out of the palm for a
/// right hand; for a left hand, y points away from the thumb. Its origin is behind the knuckles at
/// the distance of a human wrist, scaled to the size of the robot's fingers.
struct Palm {
  /// The pose of the palm in the root frame of the hand.
  Pose root_from_palm = Pose::Identity();
  /// The side of the hand.
  Side side = Side::right;
  /// The certainty of the pose.
  Provenance sure = Provenance::derived;
};
/// Finds the palm of a hand.
Palm find_palm(const Kinematics& robot, const Hand& hand, const std::vector<Pad>& pads);

}  // namespace morphe::setup
