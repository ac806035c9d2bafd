#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::check {

/// Collects what is wrong at single samples, or between two, and joins what touches.
class FindingRows {
 public:
  /// Wrong from sample `first` to sample `last`.
  void add(Cause cause, const std::string& one, const std::string& other, std::size_t first,
           std::size_t last, double depth);
  /// Ordered by begin, then cause and names. Rows of one cause and pair whose samples are
  /// neighbours are one finding, with the greatest depth.
  std::vector<Finding> join(const std::vector<double>& demonstration_time) const;

 private:
  struct Row {
    std::size_t first, last;
    double depth;
  };
  std::map<std::tuple<Cause, std::string, std::string>, std::vector<Row>> rows_;
};

}  // namespace morphe::check
