#include "stages/map/compass_search.hpp"

#include <algorithm>

namespace morphe::map {

Vec3 compass_search(const std::function<double(const Vec3&)>& f, double limit, double min_step) {
  Vec3 best_point = Vec3::Zero();
  double best_value = f(best_point);
  for (double step = limit / 2; step >= min_step; step /= 2) {
    for (bool improved = true; improved;) {
      improved = false;
      for (int axis = 0; axis < 3; ++axis) {
        for (const double change : {step, -step}) {
          Vec3 candidate = best_point;
          candidate[axis] = std::clamp(candidate[axis] + change, -limit, limit);
          if (candidate == best_point) continue;
          const double value = f(candidate);
          if (!(value < best_value)) continue;
          best_point = candidate;
          best_value = value;
          improved = true;
          break;
        }
      }
    }
  }
  return best_point;
}

}  // namespace morphe::map
