#pragma once

#include <array>
#include <cstddef>
#include <iterator>

#include "core/human/hand.hpp"

namespace morphe::human {

/// CyberGlove II, in the order of its data.
inline constexpr const char* kGloveSensors[] = {
    "ThumbRotate",  "ThumbMPJ",  "ThumbIJ",      "ThumbAb",   "IndexMPJ",      "IndexPIJ",
    "IndexDIJ",     "MiddleMPJ", "MiddlePIJ",    "MiddleDIJ", "MiddleIndexAb", "RingMPJ",
    "RingPIJ",      "RingDIJ",   "RingMiddleAb", "PinkieMPJ", "PinkiePIJ",     "PinkieDIJ",
    "PinkieRingAb", "PalmArch",  "WristPitch",   "WristYaw"};
inline constexpr std::size_t kGloveSensorCount = std::size(kGloveSensors);
using GloveAngles = std::array<double, kGloveSensorCount>;  ///< [rad]

/// What a glove says of the hand. Its abduction sensors are relative between neighbours and none
/// sees the middle finger's own: that one is taken as zero, index, ring and little follow from it.
struct GloveReading {
  HandAngles hand;
  double wrist_flexion = 0, wrist_radial_deviation = 0;  ///< [rad]
};
GloveReading decode_glove(const GloveAngles& glove);
/// The inverse: what an ideal glove reads on a hand whose middle finger is not abducted.
GloveAngles encode_glove(const GloveReading& reading);

}  // namespace morphe::human
