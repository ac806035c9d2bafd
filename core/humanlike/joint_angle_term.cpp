#include "core/humanlike/joint_angle_term.hpp"

#include <cmath>

namespace morphe::humanlike {

void JointAngle::add(const RobotState& state, const FrameGoal& goal, double share,
                     solve::Quadratic& model) const {
  for (Eigen::Index j = 0; j < goal.angles.size(); ++j) {
    const double error = state.q[j] - goal.angles[j];
    if (std::isnan(error)) continue;
    model.value += share * error * error;
    model.gradient[j] += 2 * share * error;
    model.hessian(j, j) += 2 * share;
  }
}

}  // namespace morphe::humanlike
