#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::check {

/// Collects violations at single samples or over several, and merges adjacent ones.
class FindingRows {
 public:
  /// Adds a violation from sample `first` to sample `last`; its interval is set by join().
  void add(const Finding& violation, int first, int last);
  /// Returns the findings, ordered by begin, then cause and names. Violations of one cause and pair
  /// of names that overlap or are at neighbouring samples become one finding, that of the greatest
  /// excess. `demonstration_time` has the time of each sample.
  std::vector<Finding> join(const std::vector<double>& demonstration_time) const;

 private:
  struct Row {
    int first, last;
    Finding finding;
  };
  std::map<std::tuple<Cause, std::string, std::string>, std::vector<Row>> rows_;
};

}  // namespace morphe::check
