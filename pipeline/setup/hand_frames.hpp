#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"

namespace morphe::setup {

/// Where a finger touches: z along the last bone, x out of the pad, origin on the pad's surface.
struct Pad {
  int frame = -1;  ///< the last one of the finger
  Pose frame_from_pad = Pose::Identity();
  std::string file_link;         ///< a tip that the file has itself, "" if it has none
  Vec3 file_tip = Vec3::Zero();  ///< where, in the frame
  Sure sure = Sure::assumed;
  bool beyond_shapes = false;  ///< the file's tip lies where the finger's shapes do not get to
};

/// The file's tip counts, and not where the shapes end, if it lies farther out than that.
inline constexpr double kBeyondShapes_m = 0.01;
/// How far before a finger's end its pad touches, at most: a human fingertip's half.
inline constexpr double kBeforeEnd_m = 0.008;
/// From the pad's surface to the axis of the finger, which goals are given for.
inline constexpr double kPadDepth_m = 0.010;

/// The pads of a hand's fingers, in their order. With c the foot of the end on the last joint's
/// axis: bone = end - c, normal = (axis in the sense of closing) × bone, the end being that of the
/// body's points farthest along the bone. A finger without shapes, or whose shapes end
/// before the file's own tip (a bracket without its rubber), ends in that tip, else twice as far as
/// its centre of mass. The pads of a gripper face each other across the line
/// between them.
std::vector<Pad> find_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points);

/// The palm: z to the fingers, y to the thumb's side and x out of the palm of a right hand; of a
/// left one y away from the thumb. Its origin lies behind the knuckles by as much as a human wrist
/// does, at the size of the robot's fingers.
struct Palm {
  Pose root_from_palm = Pose::Identity();
  Side side = Side::right;
  Sure sure = Sure::derived;
};
Palm find_palm(const Kinematics& robot, const Hand& hand, const std::vector<Pad>& pads);

}  // namespace morphe::setup
