#include "stages/export/lerobot/frame_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::exports {
namespace {

/// Returns the value at a share of sorted values, linear between two of them; `value_of(rank)`
/// returns those.
template <class ValueOfRank>
double interpolated_quantile(std::int64_t count, double share, const ValueOfRank& value_of) {
  const double place = share * static_cast<double>(count - 1);
  const auto below = static_cast<std::int64_t>(std::floor(place));
  const double rest = place - static_cast<double>(below);
  const double value = value_of(below);
  return rest > 0 ? std::lerp(value, value_of(below + 1), rest) : value;
}

}  // namespace

FrameStatistics statistics_of(const JointRows& rows) {
  FrameStatistics result;
  result.count = rows.rows();
  for (Eigen::Index d = 0; d < rows.cols(); ++d) {
    std::vector<double> sorted(rows.col(d).begin(), rows.col(d).end());
    std::ranges::sort(sorted);
    const double mean = rows.col(d).mean();
    result.min.push_back(sorted.front());
    result.max.push_back(sorted.back());
    result.mean.push_back(std::clamp(mean, sorted.front(), sorted.back()));
    result.std.push_back(std::sqrt((rows.col(d).array() - mean).square().mean()));
    for (std::size_t q = 0; q < kQuantileShares.size(); ++q)
      result.quantiles[q].push_back(interpolated_quantile(
          result.count, kQuantileShares[q], [&](std::int64_t rank) { return sorted[rank]; }));
  }
  return result;
}

void RunningDistribution::widen(bool down) {
  // Downwards the bins move to the upper half, upwards to the lower one, two of them into one.
  std::vector<Bin> wider(kBins);
  const std::size_t first = down ? kBins / 2 : 0;
  for (std::size_t k = 0; k < kBins; ++k) {
    wider[first + k / 2].count += bins_[k].count;
    wider[first + k / 2].sum += bins_[k].sum;
  }
  if (down) begin_ -= width_ * kBins;
  width_ *= 2;
  bins_ = std::move(wider);
}

void RunningDistribution::add(double value) {
  if (count_ == 0) {
    constexpr double kFirstWidthShare = 1e-12;  // of the first value; bins only grow
    bins_.resize(kBins);
    width_ = kFirstWidthShare * std::max(1.0, std::abs(value));
    begin_ = value - width_ * kBins / 2;
    min_ = max_ = value;
  }
  while (value < begin_) widen(true);
  while (value >= begin_ + width_ * kBins) widen(false);
  const auto bin = static_cast<std::size_t>((value - begin_) / width_);
  Bin& own = bins_[std::min(bin, kBins - 1)];
  ++own.count;
  own.sum += value;
  min_ = std::min(min_, value);
  max_ = std::max(max_, value);
  ++count_;
  const double deviation = value - mean_;
  mean_ += deviation / static_cast<double>(count_);
  squares_ += deviation * (value - mean_);
}

double RunningDistribution::std() const {
  return std::sqrt(std::max(0.0, squares_) / static_cast<double>(count_));
}

double RunningDistribution::value_of_rank(std::int64_t rank) const {
  std::int64_t before = 0;
  for (const Bin& bin : bins_) {
    before += bin.count;
    if (rank < before) return std::clamp(bin.sum / static_cast<double>(bin.count), min_, max_);
  }
  return max_;
}

double RunningDistribution::quantile(double share) const {
  return interpolated_quantile(count_, share,
                               [this](std::int64_t rank) { return value_of_rank(rank); });
}

void RunningStatistics::add(const JointRows& rows) {
  for (Eigen::Index d = 0; d < rows.cols(); ++d)
    for (const double value : rows.col(d)) dimensions_[d].add(value);
}

FrameStatistics RunningStatistics::statistics() const {
  FrameStatistics result;
  for (const RunningDistribution& each : dimensions_) {
    result.count = each.count();
    result.min.push_back(each.min());
    result.max.push_back(each.max());
    result.mean.push_back(std::clamp(each.mean(), each.min(), each.max()));
    result.std.push_back(each.std());
    for (std::size_t q = 0; q < kQuantileShares.size(); ++q)
      result.quantiles[q].push_back(each.quantile(kQuantileShares[q]));
  }
  return result;
}

}  // namespace morphe::exports
