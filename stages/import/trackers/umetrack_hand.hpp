#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {

/// UmeTrack's model of a person's left hand (a right one is its mirror image): four joints a
/// finger, thumb first, each turning about an axis through a point, and landmarks that follow up to
/// three of the bones by weight.
struct UmetrackHand {
  static constexpr std::size_t kFingerJoints = 20, kAngles = 22, kLandmarks = 21, kBones = 17;
  std::array<Vec3, kFingerJoints> axis, point;  ///< at rest, in the wrist's frame [m]
  struct Landmark {
    Vec3 rest = Vec3::Zero();  ///< [m]
    std::array<std::size_t, 3> bone{};
    std::array<double, 3> weight{};
  };
  std::array<Landmark, kLandmarks> landmarks;
};

/// umetrack_hand_user_profile.json. InputError "FILE: KEY: …" for what is missing or of another
/// size, and for bones that the model does not have.
UmetrackHand read_umetrack_hand(const std::filesystem::path& profile);

/// A hand as it was at one time [m].
struct UmetrackPoints {
  std::array<Vec3, UmetrackHand::kLandmarks> landmarks;  ///< order "aria" of keypoint_orders.hpp
  Vec3 thumb_root;  ///< where the thumb's first bone begins (CMC), which is no landmark
};

/// For the angles of the joints [rad], at least kFingerJoints.
UmetrackPoints points_of(const UmetrackHand& hand, Side side, const Pose& world_from_wrist,
                         const std::vector<double>& angles);

}  // namespace morphe::imports
