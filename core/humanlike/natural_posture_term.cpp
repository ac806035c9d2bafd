#include "core/humanlike/natural_posture_term.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::humanlike {
namespace {

bool is_active(const NaturalPosture::Joint& entry, const FrameGoal& goal) {
  return std::ranges::none_of(entry.tips,
                              [&](int tip) { return is_known(goal.tip_position[tip]); });
}

double posture_error(const NaturalPosture::Joint& entry, const JointVector& q) {
  return q[entry.joint] - (entry.follow < 0 ? 0.0 : q[entry.follow]) - entry.value;
}

}  // namespace

void NaturalPosture::add(const RobotState& state, const FrameGoal& goal, double share,
                         solve::Quadratic& model) const {
  for (const Joint& entry : joints) {
    if (!is_active(entry, goal)) continue;
    const double error = posture_error(entry, state.q);
    model.value += share * error * error;
    model.gradient[entry.joint] += 2 * share * error;
    model.hessian(entry.joint, entry.joint) += 2 * share;
    if (entry.follow < 0) continue;
    model.gradient[entry.follow] -= 2 * share * error;
    model.hessian(entry.follow, entry.follow) += 2 * share;
    model.hessian(entry.joint, entry.follow) -= 2 * share;
    model.hessian(entry.follow, entry.joint) -= 2 * share;
  }
}

void NaturalPosture::apply(const FrameGoal& goal, JointVector& q) const {
  for (const Joint& entry : joints) {
    if (is_active(entry, goal)) q[entry.joint] -= posture_error(entry, q);
  }
}

double NaturalPosture::distance(const JointVector& q, const FrameGoal& goal) const {
  double sum = 0;
  int count = 0;
  for (const Joint& entry : joints) {
    if (!is_active(entry, goal)) continue;
    const double error = posture_error(entry, q);
    sum += error * error;
    ++count;
  }
  return count == 0 ? kUnknown : std::sqrt(sum / count);
}

}  // namespace morphe::humanlike
