#pragma once

#include <string>
#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/pad_surface.hpp"

namespace morphe::setup {

/// The pad of a finger: z along the last bone, x out of the pad, origin on the surface of the pad.
struct Pad {
  int frame = -1;  ///< of the finger's last body
  Pose frame_from_pad = Pose::Identity();
  std::string urdf_tip_link;     ///< link that the file defines as tip, or ""
  Vec3 urdf_tip = Vec3::Zero();  ///< position of that link in the frame [m]
  Provenance sure = Provenance::assumed;
  bool tip_beyond_shapes = false;  ///< true if that link is beyond the finger's shapes
  bool assumed_to_meet = false;    ///< true for jaws without shapes, whose surfaces are unknown
};

/// Distance beyond the end of the shapes from which the file's tip is replaced by that end [m].
inline constexpr double kMaxTipBeyondShapes_m = 0.01;
/// Finds the pads of a hand's fingers, in their order. With c the projection of a finger's end onto
/// its last axis, bone = end - c and normal = (axis in the sense of closing) × bone. The end is the
/// point of the shapes farthest along the bone; the tip in the file if there are no shapes, or they
/// end before it (a bracket without its rubber); without both, the point twice as far from the axis
/// as the centre of mass. The normal of a sliding finger is its direction of closing. The pads of a
/// gripper face each other (gripper_pads.hpp).
std::vector<Pad> find_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points);

/// The palm frame: z towards the fingers, y to the side of the thumb and x out of the palm for a
/// right hand; for a left hand, y points away from the thumb. Its origin is behind the knuckles at
/// the distance of a human wrist, scaled to the size of the robot's fingers.
struct Palm {
  Pose root_from_palm = Pose::Identity();
  Side side = Side::right;  ///< by the geometry, of which a gripper has no side
  Provenance sure = Provenance::derived;
};
/// Finds the palm of a hand.
Palm find_palm(const Kinematics& robot, const Hand& hand, const std::vector<Pad>& pads);

}  // namespace morphe::setup
