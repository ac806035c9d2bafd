#pragma once

#include <array>
#include <cstddef>
#include <iterator>

#include "core/human/hand.hpp"

namespace morphe::human {

/// The sensors of a CyberGlove II, in the order of its data.
inline constexpr const char* kGloveSensors[] = {
    "ThumbRotate",  "ThumbMPJ",  "ThumbIJ",      "ThumbAb",   "IndexMPJ",      "IndexPIJ",
    "IndexDIJ",     "MiddleMPJ", "MiddlePIJ",    "MiddleDIJ", "MiddleIndexAb", "RingMPJ",
    "RingPIJ",      "RingDIJ",   "RingMiddleAb", "PinkieMPJ", "PinkiePIJ",     "PinkieDIJ",
    "PinkieRingAb", "PalmArch",  "WristPitch",   "WristYaw"};
/// Number of sensors.
inline constexpr std::size_t kGloveSensorCount = std::size(kGloveSensors);
/// The angles of the glove's sensors [rad].
using GloveAngles = std::array<double, kGloveSensorCount>;

/// The hand and wrist angles decoded from a glove. It measures abduction only between neighbouring
/// fingers; so that of the middle finger is taken as zero.
struct GloveReading {
  HandAngles hand;
  double wrist_flexion = 0, wrist_radial_deviation = 0;  ///< [rad]
};
/// Converts the angles of a glove's sensors to those of the hand.
GloveReading decode_glove(const GloveAngles& glove);
/// Computes the angles that an ideal glove measures. It is the inverse of decode_glove() if the
/// middle finger is not abducted.
GloveAngles encode_glove(const GloveReading& reading);

}  // namespace morphe::human
