#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe::robot {

/// The proportions of a finger of the human hand, from the ratios of Buchholz et al. (1992). Limits
/// are those of the Anthropomorphism toolbox, but abduction is always towards the thumb; the
/// toolbox counts that of ring and little finger away from it.
struct FingerProportions {
  double across;  ///< of the base, to the thumb's side, relative to hand breadth
  double along;   ///< of the base, from the wrist, relative to hand length like the phalanges
  double proximal, middle, distal;
  double splay;                        ///< rotation away from the thumb at zero abduction [rad]
  std::array<double, 4> lower, upper;  ///< abduction, MCP, PIP, DIP [rad]
};

/// The proportions of the thumb: its base, as for a finger, and three segments. Its rotation, -30
/// to 90 degrees, replaces two of the toolbox's three CMC joints, ±30 and 60 degrees.
struct ThumbProportions {
  double across, along, metacarpal, proximal, distal;
  double splay;                        ///< angle between z and the flat thumb [rad]
  std::array<double, 4> lower, upper;  ///< rotation, abduction, MCP, IP [rad]
};

/// Converts degrees to radians.
constexpr double radians(double degrees) { return degrees * kRadPerDegree; }
/// Converts degrees to radians.
constexpr std::array<double, 4> radians(std::array<double, 4> degrees) {
  for (double& angle : degrees) angle = radians(angle);
  return degrees;
}

/// Proportions of the human thumb.
inline constexpr ThumbProportions kThumbProportions = {0.196,
                                                       0.073,
                                                       0.251,
                                                       0.196,
                                                       0.158,
                                                       radians(30),
                                                       radians({-30, -25, -15, -15}),
                                                       radians({90, 35, 55, 80})};

/// Proportions of the human index, middle, ring and little finger.
inline constexpr std::array<FingerProportions, 4> kFingerProportions = {{
    {0.251, 0.447, 0.245, 0.143, 0.097, 0, radians({-13, 0, 0, -10}), radians({42, 80, 100, 90})},
    {0, 0.446, 0.266, 0.170, 0.108, radians(3), radians({-13, 0, 0, -10}),
     radians({42, 80, 100, 90})},
    {-0.206, 0.409, 0.244, 0.165, 0.107, radians(4), radians({-20, 0, 0, -20}),
     radians({14, 80, 100, 90})},
    {-0.402, 0.368, 0.204, 0.117, 0.093, radians(8), radians({-33, 0, 0, -30}),
     radians({19, 80, 100, 90})},
}};

}  // namespace morphe::robot
