#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/movement.hpp"

namespace morphe::study {

/// The comparison of found movements with labelled ones. A labelled movement begins with each label
/// `reach` and extends to the next one; it is found if the reach of a movement overlaps the
/// labelled reach by more than half of their union. Each is matched at most once.
struct SegmentationScore {
  /// The number of labelled movements, found movements and matches.
  std::size_t labelled = 0, found = 0, matched = 0;
  /// The values |found - labelled| of matched movements [s]: "reach begin", "reach end", and for
  /// every other phase that both have (the k-th of a name with the k-th) "<phase> begin" and
  /// "<phase> end".
  std::map<std::string, std::vector<double>> error_s;

  /// Matched / found, 1 if no movement was found.
  double precision() const;
  /// Matched / labelled, 1 if there are no labels.
  double recall() const;
  /// Adds the counts and errors of another recording.
  void add(const SegmentationScore& other);
};

/// Compares the movements of a recording with its labels.
SegmentationScore score_segmentation(const std::vector<Label>& labels,
                                     const std::vector<Movement>& movements);

}  // namespace morphe::study
