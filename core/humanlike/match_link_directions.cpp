#include "core/humanlike/match_link_directions.hpp"

#include <algorithm>

namespace morphe::humanlike {

Chain match_link_directions(const Chain& human, const Chain& robot) {
  if (!std::ranges::all_of(human, [](const Vec3& joint) { return is_known(joint); }))
    return Chain(robot.size(), unknown_point());
  const std::vector<double> human_knots = knots(human), robot_knots = knots(robot);
  Chain posed{robot.front()};
  for (int i = 1; i < std::ssize(robot); ++i) {
    const double middle = 0.5 * (robot_knots[i - 1] + robot_knots[i]);
    const std::ptrdiff_t end = chain_point(human_knots, middle).end;
    const Vec3 direction = (human[end] - human[end - 1]).normalized();
    posed.push_back(posed.back() + (robot[i] - robot[i - 1]).norm() * direction);
  }
  return posed;
}

}  // namespace morphe::humanlike
