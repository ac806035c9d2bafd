#include "pipeline/study/colliding_states.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/fcl_engine.hpp"
#include "core/collision/world.hpp"

namespace morphe::study {

int count_colliding_states(const robot::Robot& robot, const Plan& plan,
                           const Trajectory& trajectory, double step_m) {
  Tolerances without_margin = plan.tolerances;
  without_margin.required_clearance = 0;
  const collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, without_margin);
  collision::FclEngine engine(world);
  collision::CollisionScratch scratch;
  const auto colliding = [&](const JointVector& q, double time_s) {
    return engine.is_free(q, time_s, scratch) ? 0 : 1;
  };
  int count = 0;
  for (Eigen::Index i = 1; i < trajectory.position.rows(); ++i) {
    const JointVector from = trajectory.position.row(i - 1), to = trajectory.position.row(i);
    const double travel_m = (robot.capsule_motion_bounds * (to - from).cwiseAbs()).maxCoeff();
    const int steps = std::max(1, static_cast<int>(std::ceil(travel_m / step_m)));
    for (int k = 0; k < steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      const double from_s = trajectory.demonstration_time[i - 1];
      const double time_s = from_s + share * (trajectory.demonstration_time[i] - from_s);
      count += colliding(from + share * (to - from), time_s);
    }
  }
  const Eigen::Index last = trajectory.position.rows() - 1;
  if (last < 0) return 0;
  return count + colliding(trajectory.position.row(last), trajectory.demonstration_time[last]);
}

}  // namespace morphe::study
