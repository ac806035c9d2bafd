#pragma once

#include <array>

#include "core/human/arm.hpp"
#include "core/human/hand.hpp"

namespace morphe::human {

enum class Sex { female, male };

/// The body dimensions of a person.
struct Anthropometry {
  double stature_m = 0;
  ArmLengths arm;  ///< acromion to radiale and radiale to stylion, taken as joint centres
  HandSize hand;
};

/// Returns body dimensions from ANSUR II (4082 men, 1986 women): mean + deviate * standard
/// deviation. The deviates are those of stature, upper arm, forearm, hand length and hand breadth.
Anthropometry anthropometry(Sex sex, const std::array<double, 5>& deviates);

}  // namespace morphe::human
