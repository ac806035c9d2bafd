#include "stages/verify/grasp_held.hpp"

#include <cmath>
#include <set>
#include <vector>

#include "stages/verify/pad.hpp"

namespace morphe::verify {
namespace {

/// Largest motion of the pads in the hand that carries the target.
constexpr double kMaxHeldDrift_m = 5e-4, kMaxHeldTurn_rad = kRadPerDegree;

std::size_t padded_finger_count(const RobotModel& robot) {
  const std::vector<PadSphere> pads = pad_spheres(robot);
  std::set<int> fingers;
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip)
    if (pads[tip].capsule >= 0) fingers.insert(robot.tips[tip].finger);
  return fingers.size();
}

bool presses_towards(const PadContact& from, const PadContact& to, double friction_coefficient) {
  const Vec3 line = to.point - from.point;
  const double angle = std::atan2(from.normal.cross(line).norm(), from.normal.dot(line));
  return !line.isZero(0) && angle <= std::atan(friction_coefficient);
}

bool has_opposed_pair(const Grasp& grasp) {
  const double friction_coefficient = grasp.quality.friction_coefficient;
  for (const PadContact& first : grasp.contacts) {
    for (const PadContact& second : grasp.contacts) {
      if (first.state == ContactState::touching && second.state == ContactState::touching &&
          presses_towards(first, second, friction_coefficient) &&
          presses_towards(second, first, friction_coefficient))
        return true;
    }
  }
  return false;
}

}  // namespace

void verify_held(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  if (!plan.tolerances.max_link_penetration || padded_finger_count(robot) < 2) return;
  // The certificate's figures are compared with recomputed ones elsewhere (certificate.hpp).
  const Certificate& own = plan.certificate;
  if (own.held_drift > kMaxHeldDrift_m)
    violations.note_plan("contact", "held_drift", own.held_drift, kMaxHeldDrift_m);
  if (own.held_turn > kMaxHeldTurn_rad)
    violations.note_plan("contact", "held_turn", own.held_turn, kMaxHeldTurn_rad);
  if (has_opposed_pair(plan.grasp) || plan.grasp.quality.epsilon_lower > 0) return;
  for (const Phase& phase : plan.movement.phases) {
    if (phase.kind != PhaseKind::transport || !(phase.begin_s < plan.movement.end_s)) continue;
    violations.note_plan("contact", "opposed", phase.begin_s, kUnknown);
    return;
  }
}

}  // namespace morphe::verify
