#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/movement.hpp"

namespace morphe::study {

/// The comparison of found movements with labelled ones. A labelled movement begins with a label
/// `reach` and extends to the next one. It is matched with the first found movement whose reach
/// overlaps the labelled reach by more than half of their union. Each is matched at most once.
struct SegmentationScore {
  int labelled = 0, found = 0, matched = 0;
  /// |found - labelled| of the boundaries of matched movements, by names such as "reach begin" and
  /// "reach end". The k-th phase of a kind is compared with the k-th, as far as both exist.
  std::map<std::string, std::vector<double>> error_s;

  /// Matched / found, 1 if no movement was found.
  double precision() const;
  /// Matched / labelled, 1 if there are no labels.
  double recall() const;
  /// Returns the errors of both ends of all reaches.
  std::vector<double> reach_errors_s() const;
  /// Adds the counts and errors of another recording.
  void add(const SegmentationScore& other);
};

/// Compares the movements of a recording with its labels.
SegmentationScore score_segmentation(const std::vector<Label>& labels,
                                     const std::vector<Movement>& movements);

}  // namespace morphe::study
