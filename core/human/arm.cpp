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
  // Projection of the elbow onto the shoulder-wrist line, by the law of cosines; u == f folded:
  // distance 0.
  const double foot = distance > 0 ? (u * u - f * f + distance * distance) / (2 * distance) : 0.0;
  const double radius = std::sqrt(std::max(0.0, u * u - foot * foot));
  Vec3 aside = Vec3(0, -2, -1);
  aside -= along * along.dot(aside);
  if (aside.norm() < 1e-9) return unknown_point();
  aside.normalize();
  const Vec3 right = aside.cross(along);
  return shoulder + foot * along + radius * (std::cos(outward) * aside + std::sin(outward) * right);
}

std::optional<Vec3> shoulder_within_reach(const Vec3& wanted, const std::vector<Vec3>& wrists,
                                          double reach) {
  constexpr int kMaxProjectionCount = 10000;
  constexpr double kReachTolerance_m = 1e-6;
  Vec3 shoulder = wanted;
  for (int round = 0; round < kMaxProjectionCount; ++round) {
    const Vec3* furthest = nullptr;
    double excess = kReachTolerance_m;
    for (const Vec3& wrist : wrists) {
      if (!is_known(wrist)) continue;
      const double beyond = (shoulder - wrist).norm() - reach;
      if (beyond <= excess) continue;
      excess = beyond;
      furthest = &wrist;
    }
    if (!furthest) return shoulder;
    shoulder = *furthest + (shoulder - *furthest).normalized() * reach;
  }
  return std::nullopt;
}

}  // namespace morphe::human
