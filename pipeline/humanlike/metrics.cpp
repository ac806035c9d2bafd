#include "pipeline/humanlike/metrics.hpp"

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace morphe {
namespace {

/// Normalised arc length of each joint, 0 … 1.
std::vector<double> knots(const Chain& chain) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    lengths.push_back(lengths.back() + (chain[i] - chain[i - 1]).norm());
  }
  for (double& length : lengths) length /= lengths.back();
  lengths.back() = 1;
  return lengths;
}

Vec3 point_at(const Chain& chain, const std::vector<double>& at, double knot) {
  const auto upper = std::upper_bound(at.begin(), at.end(), knot);
  if (upper == at.end()) return chain.back();
  const auto i = static_cast<std::size_t>(upper - at.begin());
  const double share = (knot - at[i - 1]) / (at[i] - at[i - 1]);
  return (1 - share) * chain[i - 1] + share * chain[i];
}

/// Heron's formula; round-off of a flat triangle counts as zero.
double heron(double a, double b, double c) {
  return 0.25 * std::sqrt(std::max(0.0, (a + b + c) * (a - b + c) * (a + b - c) * (-a + b + c)));
}

std::vector<Vec3> distinct(const std::vector<Vec3>& points) {
  std::vector<Vec3> kept;
  for (const Vec3& point : points) {
    const bool known = std::any_of(kept.begin(), kept.end(), [&](const Vec3& other) {
      return (point - other).norm() < 1e-12;
    });
    if (!known) kept.push_back(point);
  }
  return kept;
}

double quickhull_volume(const std::vector<Vec3>& points) {
  std::vector<double> coordinates;
  for (const Vec3& point : points)
    coordinates.insert(coordinates.end(), point.begin(), point.end());
  std::FILE* silence = std::fopen("/dev/null", "w");
  qhT hull;
  qh_zero(&hull, silence);
  char command[] = "qhull FA";
  const int failed = qh_new_qhull(&hull, 3, static_cast<int>(points.size()), coordinates.data(), 0,
                                  command, silence, silence);
  double volume = 0;
  if (!failed) {  // it fails on flat sets, whose volume is zero
    qh_getarea(&hull, hull.facet_list);
    volume = hull.totvol;
  }
  qh_freeqhull(&hull, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(&hull, &current, &total);
  if (silence) std::fclose(silence);
  return volume;
}

}  // namespace

double joint_distance_sum(const Vec3& human_elbow, const std::vector<Vec3>& inner_centres) {
  double sum = 0;
  for (const Vec3& centre : inner_centres) sum += (human_elbow - centre).squaredNorm();
  return sum;
}

double triangle_area_sum(const Chain& human, const Chain& robot) {
  const std::vector<double> human_knots = knots(human), robot_knots = knots(robot);
  std::vector<double> all = human_knots;
  all.insert(all.end(), robot_knots.begin(), robot_knots.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < 1e-12; }),
            all.end());
  double sum = 0;
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const Vec3 joint = point_at(human, human_knots, all[i]);
    const Vec3 corresponding = point_at(robot, robot_knots, all[i]);
    const Vec3 next = point_at(robot, robot_knots, all[i + 1]);
    sum +=
        heron((joint - corresponding).norm(), (corresponding - next).norm(), (next - joint).norm());
  }
  return sum;
}

double hull_volume(const std::vector<Vec3>& points) {
  const std::vector<Vec3> corners = distinct(points);
  if (corners.size() < 4) return 0;
  if (corners.size() == 4) {
    Eigen::Matrix3d edges;
    for (int i = 0; i < 3; ++i)
      edges.col(i) = corners[static_cast<std::size_t>(i) + 1] - corners[0];
    return std::abs(edges.determinant()) / 6;
  }
  return quickhull_volume(corners);
}

double hull_volume_sum(const Chain& human, const Chain& robot) {
  const double elbow_knot = knots(human)[1];
  const std::vector<double> robot_knots = knots(robot);
  std::vector<Vec3> upper{human[0], human[1]}, lower{human[1], human[2]};
  for (std::size_t i = 0; i < robot.size(); ++i) {
    (robot_knots[i] <= elbow_knot ? upper : lower).push_back(robot[i]);
  }
  return hull_volume(upper) + hull_volume(lower);
}

}  // namespace morphe
