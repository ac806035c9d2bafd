#pragma once

#include <array>
#include <cstddef>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The joint columns of an Adroit recording: forearm, wrist, index, middle, ring, little, thumb.
/// The forearm's slide ARTz is not recorded.
inline constexpr const char* kAdroitJoints[] = {
    "ARRx", "ARRy", "ARRz", "WRJ1", "WRJ0", "FFJ3", "FFJ2", "FFJ1", "FFJ0",
    "MFJ3", "MFJ2", "MFJ1", "MFJ0", "RFJ3", "RFJ2", "RFJ1", "RFJ0", "LFJ4",
    "LFJ3", "LFJ2", "LFJ1", "LFJ0", "THJ4", "THJ3", "THJ2", "THJ1", "THJ0"};
inline constexpr std::size_t kAdroitJointCount = std::size(kAdroitJoints);  ///< number of columns
using AdroitAngles = std::array<double, kAdroitJointCount>;                 ///< [rad]

/// Returns the palm's pose in the world; the forearm has moved along its slide by `slide_m`:
///   T(0, -0.7, 0.2) RxRyRz(-1.57, 0, 3.14) T(z slide) Rx(ARRx) Ry(ARRy) Rz(ARRz)
///   T(z 0.396) Ry(WRJ1) T(z 0.032) Rx(WRJ0).
/// Palm frame: origin at the wrist, z to the fingers, the palm facing -y, x to the thumb's side.
Pose adroit_world_from_palm(const AdroitAngles& angles, double slide_m);

/// Returns the point recorded as "palm xyz", in the palm frame [m].
inline Vec3 adroit_palm_point() { return {0.007, -0.051, 0.073}; }

/// Returns the centres of the five fingertips in the palm frame, thumb … little [m]: the Shadow
/// hand's chains, each to the end of its distal phalanx's axis.
std::array<Vec3, 5> adroit_fingertips(const AdroitAngles& angles);

/// Returns palm_from_hand, the axes of HumanMotion's hand frame in the palm frame.
Eigen::Matrix3d adroit_palm_from_hand();

}  // namespace morphe::imports
