#include "core/humanlike/triangle_area_term.hpp"

#include "core/humanlike/arm_metric.hpp"
#include "core/humanlike/chain_gradients.hpp"

namespace morphe::humanlike {

void TriangleArea::add(const RobotState& state, const FrameGoal& goal, double share,
                       Loads& loads) const {
  const auto metric_of = [this](const Chain& human, const Chain& robot) {
    return triangle_area_gradient(human, robot, smoothing_m2);
  };
  add_arm_metric(state, goal, share, metric_of, loads);
}

}  // namespace morphe::humanlike
