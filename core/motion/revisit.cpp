#include "core/motion/revisit.hpp"

#include <algorithm>

namespace morphe {

double revisit_score(const Vec3& first, const Vec3& second, double out_m, double away_m) {
  const double ratio = (second - first).norm() / (std::min(out_m, away_m) / 2);
  return 1 - ratio * ratio;
}

}  // namespace morphe
