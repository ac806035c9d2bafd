#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::check {

/// Collects violations at single samples, or between two samples, and merges adjacent ones.
class FindingRows {
 public:
  /// Adds a violation from sample `first` to sample `last`.
  void add(Cause cause, const std::string& one, const std::string& other, std::size_t first,
           std::size_t last, double depth);
  /// Returns the findings, ordered by begin, then cause and names. Rows of one cause and pair whose
  /// samples are neighbours become one finding, with the greatest depth.
  std::vector<Finding> join(const std::vector<double>& demonstration_time) const;

 private:
  struct Row {
    std::size_t first, last;
    double depth;
  };
  std::map<std::tuple<Cause, std::string, std::string>, std::vector<Row>> rows_;
};

}  // namespace morphe::check
