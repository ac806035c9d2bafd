#include "core/humanlike/metrics.hpp"

#include <algorithm>
#include <cmath>

#include "core/humanlike/chain_gradients.hpp"

namespace morphe::humanlike {
namespace {

/// Computes a triangle's area by Heron's formula, whose radicand rounding may make negative.
double triangle_area(double a, double b, double c) {
  return 0.25 * std::sqrt(std::max(0.0, (a + b + c) * (a - b + c) * (a + b - c) * (-a + b + c)));
}

}  // namespace

double joint_distance_sum(const Vec3& human_elbow, const std::vector<Vec3>& inner_centres) {
  double sum = 0;
  for (const Vec3& centre : inner_centres) sum += (human_elbow - centre).squaredNorm();
  return sum;
}

double triangle_area_sum(const Chain& human, const Chain& robot) {
  const std::vector<double> human_knots = knots(human), robot_knots = knots(robot);
  const std::vector<double> all = all_knots(human_knots, robot_knots);
  double sum = 0;
  for (int i = 1; i + 1 < std::ssize(all); ++i) {
    const Vec3 joint = chain_point(human_knots, all[i]).point_on(human);
    const Vec3 corresponding = chain_point(robot_knots, all[i]).point_on(robot);
    const Vec3 next = chain_point(robot_knots, all[i + 1]).point_on(robot);
    sum += triangle_area((joint - corresponding).norm(), (corresponding - next).norm(),
                         (next - joint).norm());
  }
  return sum;
}

double hull_volume_sum(const Chain& human, const Chain& robot) {
  return hull_volume_gradient(human, robot).value;
}

}  // namespace morphe::humanlike
