#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stages/import/audit/label_clusters.hpp"

namespace morphe::imports {

/// The markers or joints at the tips of thumb and index finger, and what tells one from the other.
struct DigitMarkers {
  std::size_t thumb = 0, index = 0;  ///< columns
  std::vector<std::size_t> forearm;  ///< columns of its cluster, else of landmarks or joints
  std::optional<RigidCluster> hand;  ///< if its shape and both tips are in the static trial
  Vec3 static_thumb, static_index;   ///< in the static trial's world [m]
};

/// Returns the tips of one side's hand, "right" or "left"; no value if one of them is not seen.
std::optional<DigitMarkers> digit_markers(const MarkerStream& markers,
                                          const std::optional<MarkerStream>& static_trial,
                                          const std::vector<RigidCluster>& clusters,
                                          const std::string& side);

/// Returns the tips among the joints of one side; no value if one of them is missing, or if other
/// joints of thumb or index finger tell which is which. `forearm` are elbow and wrist.
std::optional<DigitMarkers> digit_joints(const std::vector<std::string>& names,
                                         const std::string& side);

/// Whether the tips carry their own names.
enum class DigitOrder { unknown, own, exchanged };

/// Judges the names of the tips in the frames from `begin` to `end`. Two things tell: the index tip
/// is farther from the forearm than the thumb's (10 mm or more in the median), and, in the frame of
/// the hand, the tips are nearer to their own places in the static trial than to each other's (30
/// mm or more). If these contradict each other, the order is unknown.
DigitOrder digit_order(const Array2D<Vec3>& position, std::size_t begin, std::size_t end,
                       const DigitMarkers& digits);

/// Returns the first frame of each part of a recording in which the names of the tips cannot change
/// unnoticed: a part begins at frame 0 and when one of them is seen again.
std::vector<std::size_t> digit_parts(const Array2D<Vec3>& position, const DigitMarkers& digits);

}  // namespace morphe::imports
