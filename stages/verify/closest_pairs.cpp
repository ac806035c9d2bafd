#include "stages/verify/closest_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stages/verify/carried_object.hpp"

namespace morphe::verify {
namespace {

/// Returns true if a pair is that of a stored clearance.
bool is_pair_of(const RobotModel& robot, const Plan& plan, const ContactPair& pair,
                const KindClearance& stored) {
  const std::string& first = robot.capsules[pair.capsule].name;
  const std::string& second =
      pair.is_object ? plan.scene.objects[pair.other].name : robot.capsules[pair.other].name;
  const bool same = (first == stored.first && second == stored.second) ||
                    (!pair.is_object && first == stored.second && second == stored.first);
  return same && kind_of_pair(plan, pair) == stored.kind;
}

/// Returns the distance of the named pair at the named time; NaN if there is no such pair.
double distance_of(const Plan& plan, const Curve& curve, const std::vector<ContactPair>& pairs,
                   BodyDistances& bodies, const KindClearance& stored) {
  const std::vector<double>& time = curve.trajectory->time;
  if (!(stored.time_s >= time.front() && stored.time_s <= time.back())) return kUnknown;
  const auto after = std::ranges::upper_bound(time, stored.time_s) - time.begin();
  const int piece = std::clamp(static_cast<int>(after) - 1, 0, curve.pieces - 1);
  const double s = (stored.time_s - time[piece]) / (time[piece + 1] - time[piece]);
  const double time_s = curve.demonstration_time_at(piece, s);
  JointVector q;
  curve.position_at(piece, s, q);
  if (stored.first == plan.movement.target)
    return carried_distance(bodies.robot(), plan, bodies.meshes(), bodies.attached(), stored.second,
                            q, time_s);
  bodies.move_to(q, time_s);
  const auto pair = std::ranges::find_if(pairs, [&](const ContactPair& each) {
    return is_pair_of(bodies.robot(), plan, each, stored);
  });
  return pair == pairs.end() ? kUnknown : bodies.distance(*pair, kInfinity);
}

}  // namespace

ClearanceKind kind_of_pair(const Plan& plan, const ContactPair& pair) {
  return pair.is_object ? kind_of_object(plan.scene.objects[pair.other].name, plan.movement.target)
                        : ClearanceKind::self;
}

void verify_closest_pairs(const Plan& plan, const Curve& curve,
                          const std::vector<ContactPair>& pairs, BodyDistances& bodies,
                          ViolationLog& violations) {
  for (const KindClearance& stored : plan.certificate.clearance_by_kind) {
    const double value = distance_of(plan, curve, pairs, bodies, stored);
    if (std::abs(value - stored.clearance) <= kStoredClearanceTolerance_m) continue;
    violations.note_plan("certificate",
                         fmt::format("clearance_by_kind/{}/pair", name_of(stored.kind)),
                         stored.clearance, value);
  }
}

}  // namespace morphe::verify
