#include "core/humanlike/knots.hpp"

#include <algorithm>

namespace morphe::humanlike {

std::vector<double> knots(const Chain& chain) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    lengths.push_back(lengths.back() + (chain[i] - chain[i - 1]).norm());
  }
  for (double& length : lengths) length /= lengths.back();
  lengths.back() = 1;
  return lengths;
}

std::vector<double> all_knots(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < 1e-12; }),
            all.end());
  return all;
}

ChainPoint chain_point(const std::vector<double>& at, double knot) {
  const auto upper = std::upper_bound(at.begin(), at.end(), knot);
  if (upper == at.end()) return {at.size() - 1, 1};
  const auto end = static_cast<std::size_t>(upper - at.begin());
  return {end, (knot - at[end - 1]) / (at[end] - at[end - 1])};
}

}  // namespace morphe::humanlike
