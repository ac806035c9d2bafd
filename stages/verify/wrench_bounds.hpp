#pragma once

#include <functional>

#include "stages/verify/pressing.hpp"

namespace morphe::verify {

/// lower <= value <= upper.
struct Between {
  double lower = -kInfinity, upper = kInfinity;
};

/// Ferrari and Canny's epsilon, min over |u| = 1 of h(u), of forces that sum to 1. From above: h(u)
/// of the best u that a descent from many starts finds. From below: the least distance of a facet
/// of the hull of wrenches that the contacts can bring about from 0, and minus the length of the
/// shortest such wrench that is found, whichever is more. As near as 5 % or 1e-3, as a rule, or
/// until no more can be said against bounds that are `said` than that.
Between epsilon_between(const Pressing& pressing, const Between& said = {});

/// The least h(u) / g(u), of forces that each are at most 1, likewise; g(s u) = s g(u) >= 0 for
/// s > 0, convex. Never below 0.
using Doing = std::function<double(const Vector6&)>;
Between ratio_between(const Pressing& pressing, const Doing& g, const Between& said = {});

}  // namespace morphe::verify
