#pragma once

#include <array>

#include "core/motion/geometry.hpp"

namespace morphe {

/// Where a hand's digits begin and how long they are, in its own frame (z to the fingers, y to the
/// thumb, x out of the palm), thumb first. NaN: there is no such digit, or it is not known.
struct HandBones {
  std::array<Vec3, 5> knuckle{unseen_point(), unseen_point(), unseen_point(), unseen_point(),
                              unseen_point()};  ///< [m]
  std::array<double, 5> length{kNotSeen, kNotSeen, kNotSeen, kNotSeen,
                               kNotSeen};  ///< knuckle's axis to the tip, stretched [m]
};

}  // namespace morphe
