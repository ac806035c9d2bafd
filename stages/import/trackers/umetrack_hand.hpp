#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {

/// UmeTrack's model of a person's left hand (a right one is its mirror image): four joints per
/// finger, thumb first, each rotating about an axis through a point, and landmarks attached to up
/// to three of the bones by weight.
struct UmetrackHand {
  static constexpr std::size_t kFingerJointCount = 20, kAngleCount = 22, kLandmarkCount = 21,
                               kBoneCount = 17;
  /// Axes and points of the joints at rest, in the wrist's frame [m].
  std::array<Vec3, kFingerJointCount> axis, point;
  /// A landmark with its rest position [m] and the weights of its bones.
  struct Landmark {
    Vec3 rest = Vec3::Zero();  ///< [m]
    std::array<std::size_t, 3> bone{};
    std::array<double, 3> weight{};
  };
  std::array<Landmark, kLandmarkCount> landmarks;  ///< order "aria" of keypoint_orders.hpp
};

/// Reads umetrack_hand_user_profile.json. Throws InputError "FILE: KEY: …" for data that are
/// missing or of another size, and for bones that the model does not have.
UmetrackHand read_umetrack_hand(const std::filesystem::path& profile);

/// The points of a hand at one time [m].
struct UmetrackPoints {
  std::array<Vec3, UmetrackHand::kLandmarkCount>
      landmarks;   ///< order "aria" of keypoint_orders.hpp
  Vec3 thumb_cmc;  ///< proximal end of the thumb's first bone (CMC), which is not a landmark
};

/// Computes the points for the joint angles [rad], of which there must be at least
/// kFingerJointCount.
UmetrackPoints umetrack_forward_kinematics(const UmetrackHand& hand, Side side,
                                           const Pose& world_from_wrist,
                                           const std::vector<double>& angles);

}  // namespace morphe::imports
