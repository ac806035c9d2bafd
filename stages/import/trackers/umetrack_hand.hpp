#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {

/// UmeTrack's model of a person's left hand; a right hand is its mirror image. It has four joints
/// per finger, thumb first, each with an axis through a point, and landmarks that move with bones.
struct UmetrackHand {
  static constexpr int kFingerJointCount = 20, kAngleCount = 22, kLandmarkCount = 21,
                       kBoneCount = 17;
  /// Axes and points of the joints at rest, in the wrist's frame [m].
  std::array<Vec3, kFingerJointCount> axis, point;
  /// A landmark, at the weighted mean of its rest position as moved by each of up to three bones.
  struct Landmark {
    Vec3 rest = Vec3::Zero();  ///< [m]
    std::array<int, 3> bone{};
    std::array<double, 3> weight{};
  };
  std::array<Landmark, kLandmarkCount> landmarks;  ///< order "aria" of keypoint_orders.hpp
};

/// Reads umetrack_hand_user_profile.json. Throws InputError "FILE: KEY: …" for data that are
/// missing or of another size, and for bones that the model does not have.
UmetrackHand read_umetrack_hand(const std::filesystem::path& profile);

/// The points of a hand at one time [m].
struct UmetrackPoints {
  std::array<Vec3, UmetrackHand::kLandmarkCount> landmarks;  ///< in the order "aria"
  Vec3 thumb_cmc;  ///< proximal end of the thumb's first bone, which is not a landmark
};

/// Computes the points in the world. `angles` has at least kFingerJointCount joint angles [rad].
UmetrackPoints umetrack_forward_kinematics(const UmetrackHand& hand, Side side,
                                           const Pose& world_from_wrist,
                                           const std::vector<double>& angles);

}  // namespace morphe::imports
