#include "stages/map/movement_cost.hpp"

#include <cmath>

namespace morphe::map {

double mean_step(const std::vector<double>& time) {
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

std::array<JointVector, 3> difference_weights(const RobotModel& robot,
                                              const std::vector<double>& time,
                                              const MovementCost& cost) {
  const double step_s = mean_step(time);
  const auto weight = [&](double factor, const JointVector& limit, int order) -> JointVector {
    const JointVector difference_at_limit = limit * std::pow(step_s, order);
    return factor * (step_s / kReferenceStep_s) * difference_at_limit.cwiseAbs2().cwiseInverse();
  };
  return {weight(cost.velocity, robot.velocity, 1),
          weight(cost.acceleration, robot.acceleration, 2), weight(cost.jerk, robot.jerk, 3)};
}

}  // namespace morphe::map
