#include "core/humanlike/knots.hpp"

#include <algorithm>

namespace morphe::humanlike {

std::vector<double> knots(const Chain& chain) {
  std::vector<double> lengths{0};
  for (int i = 1; i < std::ssize(chain); ++i)
    lengths.push_back(lengths.back() + (chain[i] - chain[i - 1]).norm());
  for (double& length : lengths) length /= lengths.back();
  lengths.back() = 1;
  return lengths;
}

std::vector<double> all_knots(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  std::ranges::sort(all);
  const auto same = [](double a, double b) { return b - a < 1e-12; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

ChainPoint chain_point(const std::vector<double>& knots, double knot) {
  const std::ptrdiff_t end = std::ranges::upper_bound(knots, knot) - knots.begin();
  if (end == std::ssize(knots)) return {end - 1, 1};
  return {end, (knot - knots[end - 1]) / (knots[end] - knots[end - 1])};
}

}  // namespace morphe::humanlike
