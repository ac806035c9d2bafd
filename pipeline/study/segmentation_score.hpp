#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/movement.hpp"

namespace morphe::study {

/// Found movements against labelled ones. A labelled movement begins with each label `reach` and
/// goes on to the next one; it is found if a movement's reach overlaps the labelled reach by more
/// than half of their union. Each is matched at most once.
struct SegmentationScore {
  std::size_t labelled = 0, found = 0, matched = 0;
  /// |found - labelled| of matched movements [s]: "reach begin", "reach end", and for every other
  /// phase that both have (the k-th of its name with the k-th) "<phase> begin" and "<phase> end".
  std::map<std::string, std::vector<double>> error_s;

  double precision() const;  ///< matched / found, 1 if nothing was found
  double recall() const;     ///< matched / labelled, 1 if nothing is labelled
  void add(const SegmentationScore& other);
};

SegmentationScore score_segmentation(const std::vector<Label>& labels,
                                     const std::vector<Movement>& movements);

}  // namespace morphe::study
