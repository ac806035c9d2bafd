#pragma once

#include <array>

#include "core/human/arm.hpp"
#include "core/human/hand.hpp"

namespace morphe::human {

enum class Sex { female, male };

/// The body dimensions of a person.
struct Anthropometry {
  double stature_m = 0;
  ArmLengths arm;  ///< between joint centres: acromion-radiale and radiale-stylion lengths
  HandSize hand;
};

/// Returns body dimensions from ANSUR II (4082 men, 1986 women): for each measure the mean plus its
/// standard deviation times the given deviate. Deviates: stature, upper arm, forearm, hand length,
/// hand breadth.
Anthropometry anthropometry(Sex sex, const std::array<double, 5>& deviates);

}  // namespace morphe::human
