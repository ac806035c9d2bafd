#include "pipeline/humanlike/centre_load.hpp"

#include <algorithm>

namespace morphe::humanlike {

void add_centre(const RobotState& state, const RobotTable::Centre& centre, const Vec3& reference,
                double weight, Loads& loads) {
  if (!seen(reference)) return;
  const auto count =
      std::count_if(state.robot.centres.begin(), state.robot.centres.end(),
                    [&](const RobotTable::Centre& other) { return other.chain == centre.chain; });
  loads.add_point(centre.frame, state.pose_of(centre.frame).translation(), reference,
                  weight / static_cast<double>(count), false);
}

}  // namespace morphe::humanlike
