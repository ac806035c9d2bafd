#include "core/humanlike/match_link_directions.hpp"

#include <algorithm>

#include "core/humanlike/knots.hpp"

namespace morphe::humanlike {

Chain match_link_directions(const Chain& human, const Chain& robot) {
  if (!std::ranges::all_of(human, [](const Vec3& joint) { return is_known(joint); })) {
    return Chain(robot.size(), unknown_point());
  }
  const std::vector<double> human_knots = knots(human), robot_knots = knots(robot);
  Chain posed{robot.front()};
  for (std::size_t i = 1; i < robot.size(); ++i) {
    const ChainPoint beside = chain_point(human_knots, 0.5 * (robot_knots[i - 1] + robot_knots[i]));
    const Vec3 along = (human[beside.end] - human[beside.end - 1]).normalized();
    posed.push_back(posed.back() + (robot[i] - robot[i - 1]).norm() * along);
  }
  return posed;
}

}  // namespace morphe::humanlike
