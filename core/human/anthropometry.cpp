#include "core/human/anthropometry.hpp"

namespace morphe::human {
namespace {

struct Measure {
  double mean, deviation;  ///< [m]
};
/// ANSUR II: stature, acromion-radiale, radiale-stylion, hand length, hand breadth.
constexpr Measure kWomen[] = {
    {1.629, 0.064}, {0.311, 0.017}, {0.241, 0.015}, {0.181, 0.010}, {0.078, 0.004}};
constexpr Measure kMen[] = {
    {1.756, 0.069}, {0.335, 0.018}, {0.268, 0.015}, {0.193, 0.010}, {0.088, 0.004}};

}  // namespace

Anthropometry anthropometry(Sex sex, const std::array<double, 5>& deviates) {
  const Measure* const table = sex == Sex::female ? kWomen : kMen;
  const auto measure = [&](int k) { return table[k].mean + table[k].deviation * deviates[k]; };
  return {measure(0), {measure(1), measure(2)}, {measure(3), measure(4)}};
}

}  // namespace morphe::human
