#include "pipeline/report/outline_points.hpp"

#include <cmath>

namespace morphe::report {

std::vector<Vec3> outline_points(const SceneObject& object) {
  std::vector<Vec3> points;
  const std::vector<double>& size = object.size;
  const auto add_ring = [&](double radius, double z) {
    constexpr int kPointsPerRing = 24;
    for (int k = 0; k < kPointsPerRing; ++k) {
      const double angle = 2 * M_PI * k / kPointsPerRing;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  };
  const auto add_ball = [&](double radius, double z) {
    for (const double height : {-1.0, -0.9, -0.6, -0.3, 0.0, 0.3, 0.6, 0.9, 1.0})
      add_ring(radius * std::sqrt(1 - height * height), z + radius * height);
  };
  switch (object.shape) {
    case Shape::sphere:
      add_ball(size[0], 0);
      break;
    case Shape::box:
      for (int corner = 0; corner < 8; ++corner) {
        points.push_back({((corner & 1) != 0 ? 0.5 : -0.5) * size[0],
                          ((corner & 2) != 0 ? 0.5 : -0.5) * size[1],
                          ((corner & 4) != 0 ? 0.5 : -0.5) * size[2]});
      }
      break;
    case Shape::cylinder:
      for (const double end : {-0.5, 0.5}) add_ring(size[0], end * size[1]);
      break;
    case Shape::capsule:
      for (const double end : {-0.5, 0.5}) add_ball(size[0], end * size[1]);
      break;
    case Shape::mesh:
      points = object.vertices;
      break;
  }
  return points;
}

}  // namespace morphe::report
