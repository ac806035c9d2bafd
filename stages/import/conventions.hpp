#pragma once

#include <optional>
#include <string>

#include "pipeline/motion/geometry.hpp"

namespace morphe::imports {

/// What a recording's file may leave unsaid, from the command line or a manifest.
struct Conventions {
  /// The recorded axes that point to the subject's right, forward and up: "x y z", "-z -x y".
  std::string axes;
  std::string unit;               ///< of lengths: m, cm, mm, in, or metres per unit as a number
  std::optional<double> rate_hz;  ///< frames a second
};

/// Rotation that brings a recorded point into the world (X right, Y forward, Z up); row k picks the
/// recorded axis that the k-th word of `axes` names. InputError, with `source` (a file, or what
/// gave the axes) in front, unless the words are three different axes of a right-handed frame.
Eigen::Matrix3d world_from_recorded(const std::string& axes, const std::string& source);

/// Metres in one unit of the given name; InputError with `source` in front if it is none.
double metres_per_unit(const std::string& unit, const std::string& source);

}  // namespace morphe::imports
