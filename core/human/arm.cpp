#include "core/human/arm.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::human {

ArmLengths arm_lengths_of_stature(double stature_m) {
  return {0.186 * stature_m, 0.146 * stature_m};
}

Vec3 elbow_from_swivel(const Vec3& shoulder, const Vec3& wrist, const ArmLengths& lengths,
                       double outward) {
  const double u = lengths.upper_arm, f = lengths.forearm;
  const double recorded = (wrist - shoulder).norm();
  if (!(recorded > 0)) return unknown_point();
  const Vec3 along = (wrist - shoulder) / recorded;
  const double distance = std::clamp(recorded, std::abs(u - f), u + f);
  // Distance of the elbow's foot on the shoulder-wrist line from the shoulder. If u == f, the
  // distance of a folded arm's wrist is 0.
  const double foot = distance > 0 ? (u * u - f * f + distance * distance) / (2 * distance) : 0.0;
  const double radius = std::sqrt(std::max(0.0, u * u - foot * foot));
  Vec3 reference = Vec3(0, -2, -1);
  reference -= along * along.dot(reference);
  if (reference.norm() < 1e-9) return unknown_point();
  reference.normalize();
  const Vec3 right = reference.cross(along);
  return shoulder + foot * along +
         radius * (std::cos(outward) * reference + std::sin(outward) * right);
}

std::optional<Vec3> shoulder_within_reach(const Vec3& estimate, const std::vector<Vec3>& wrists,
                                          double arm_length_m) {
  constexpr int kMaxProjectionCount = 10000;
  constexpr double kLengthTolerance_m = 1e-6;
  Vec3 shoulder = estimate;
  for (int k = 0; k < kMaxProjectionCount; ++k) {
    const Vec3* furthest = nullptr;
    double max_excess_m = kLengthTolerance_m;
    for (const Vec3& wrist : wrists) {
      if (!is_known(wrist)) continue;
      const double excess_m = (shoulder - wrist).norm() - arm_length_m;
      if (excess_m <= max_excess_m) continue;
      max_excess_m = excess_m;
      furthest = &wrist;
    }
    if (!furthest) return shoulder;
    shoulder = *furthest + (shoulder - *furthest).normalized() * arm_length_m;
  }
  return std::nullopt;
}

}  // namespace morphe::human
