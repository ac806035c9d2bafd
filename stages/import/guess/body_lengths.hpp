#pragma once

#include <vector>

#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// A length of the body in recorded units and its usual value [m].
struct BodyLength {
  const char* name;
  double recorded, usual_m;
  /// Returns recorded / usual if one recorded unit has this length [m].
  double ratio(double metres = 1) const { return recorded * metres / usual_m; }
};

/// Returns the lengths that were recorded, with the usual values of adults between joint centres.
/// Clusters of markers in place of joint centres make a length up to a third shorter or longer.
std::vector<BodyLength> body_lengths(const RecordedPoints& points);

/// Returns the lengths of the palms, from the wrist to the knuckles of index and middle finger,
/// which skeletons that end at the hand do not have.
std::vector<BodyLength> palm_lengths(const RecordedPoints& points);

/// Returns the size of the body relative to a usual adult: the geometric mean of the ratios; NaN
/// without lengths.
double relative_size(const std::vector<BodyLength>& lengths);

/// Returns a length as text: "80 mm", "1.23 m".
std::string length_text(double metres);

}  // namespace morphe::imports
