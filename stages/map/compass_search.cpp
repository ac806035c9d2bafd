#include "stages/map/compass_search.hpp"

#include <algorithm>

namespace morphe::map {

Vec3 compass_search(const std::function<double(const Vec3&)>& function, double limit,
                    double finest) {
  Vec3 best = Vec3::Zero();
  double least = function(best);
  for (double step = limit / 2; step >= finest; step /= 2) {
    bool gained = true;
    while (gained) {
      gained = false;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        for (const double way : {step, -step}) {
          Vec3 next = best;
          next[axis] = std::clamp(next[axis] + way, -limit, limit);
          if (next == best) continue;
          const double value = function(next);
          if (!(value < least)) continue;
          best = next;
          least = value;
          gained = true;
          break;
        }
      }
    }
  }
  return best;
}

}  // namespace morphe::map
