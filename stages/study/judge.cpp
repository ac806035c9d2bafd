#include "stages/study/judge.hpp"

#include <algorithm>
#include <cmath>

namespace morphe {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return kNotSeen;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  std::ranges::sort(values);
  return values[std::min(values.size(), std::max<std::size_t>(rank, 1)) - 1];
}

StudyRow row_of(const Case& of, const std::string& metric, const std::string& unit, double ours,
                std::size_t n) {
  StudyRow row;
  row.of = of;
  row.metric = metric;
  row.unit = unit;
  row.ours = ours;
  row.n = n;
  return row;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  std::size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    ++count;
  }
  return count == 0 ? kNotSeen : sum / static_cast<double>(count);
}

}  // namespace morphe
