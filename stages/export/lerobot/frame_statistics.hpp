#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::exports {

/// The shares of the quantiles that LeRobot stores, with their names.
inline constexpr std::array<double, 5> kQuantileShares{0.01, 0.1, 0.5, 0.9, 0.99};
inline constexpr std::array<const char*, 5> kQuantileNames{"q01", "q10", "q50", "q90", "q99"};

/// Statistics of a feature over frames; each list has one number per dimension. The standard
/// deviation is that of the population.
struct FrameStatistics {
  std::int64_t count = 0;
  std::vector<double> min, max, mean, std;
  std::array<std::vector<double>, kQuantileShares.size()> quantiles;
};

/// Returns the statistics of the rows, of which there is at least one. Quantiles are exact, linear
/// between two values.
FrameStatistics statistics_of(const JointRows& rows);

/// A distribution of numbers in constant memory: a histogram whose bins double in width when a
/// number is outside. Quantiles are exact up to a bin's width, which is at most 1/500 of the
/// range, and exact if each bin holds equal numbers.
class RunningDistribution {
 public:
  void add(double value);
  std::int64_t count() const { return count_; }
  double min() const { return min_; }
  double max() const { return max_; }
  double mean() const { return mean_; }
  double std() const;
  double quantile(double share) const;

 private:
  struct Bin {
    std::int64_t count = 0;
    double sum = 0;
  };
  void widen(bool down);
  double value_of_rank(std::int64_t rank) const;

  static constexpr std::size_t kBins = 8192;
  std::vector<Bin> bins_;
  double begin_ = 0, width_ = 0;  ///< bin k is [begin + k width, begin + (k + 1) width)
  std::int64_t count_ = 0;
  double min_ = 0, max_ = 0, mean_ = 0, squares_ = 0;
};

/// Statistics over the frames of many episodes, in constant memory.
class RunningStatistics {
 public:
  explicit RunningStatistics(std::size_t width) : dimensions_(width) {}
  void add(const JointRows& rows);
  FrameStatistics statistics() const;

 private:
  std::vector<RunningDistribution> dimensions_;
};

}  // namespace morphe::exports
