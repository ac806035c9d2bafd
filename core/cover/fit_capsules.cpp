#include "core/cover/fit_capsules.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/cover/capsule_surface.hpp"
#include "core/cover/choose_segments.hpp"
#include "core/cover/constants.hpp"
#include "core/cover/surface.hpp"
#include "core/cover/voxels.hpp"
#include "core/math/random_stream.hpp"
#include "core/math/rotation.hpp"
#include "core/math/statistics.hpp"

namespace morphe::cover {
namespace {

using collision::CapsuleBody;

double farthest_distance(const std::vector<Vec3>& points, const Vec3& from, const Vec3& to) {
  double max_m = 0;
  for (const Vec3& point : points) max_m = std::max(max_m, distance_to_segment(point, from, to));
  return max_m;
}

/// Assigns every point to the capsule in which it is deepest.
std::vector<std::vector<Vec3>> assign_points(const std::vector<CapsuleBody>& capsules,
                                             const std::vector<Vec3>& points) {
  std::vector<std::vector<Vec3>> own(capsules.size());
  for (const Vec3& point : points) {
    std::vector<Vec3>* deepest = own.data();
    double min_outside = kInfinity;
    for (int c = 0; c < std::ssize(capsules); ++c) {
      const double outside =
          distance_to_segment(point, capsules[c].from, capsules[c].to) - capsules[c].radius;
      if (!(outside < min_outside)) continue;
      min_outside = outside;
      deepest = &own[c];
    }
    deepest->push_back(point);
  }
  return own;
}

/// Moves the capsules' ends at random while the cost falls; radii are the least to enclose points.
void refine(std::vector<CapsuleBody>& capsules, const std::vector<Vec3>& points,
            const Voxels& voxels, const std::string& name) {
  math::RandomStream random(3, name);
  double move_m = kFirstMove_cells * voxels.step_m;
  for (int round = 0; round < kRefineRoundCount; ++round) {
    const std::vector<std::vector<Vec3>> own = assign_points(capsules, points);
    for (int c = 0; c < std::ssize(capsules); ++c) {
      if (own[c].empty()) continue;
      CapsuleBody& capsule = capsules[c];
      capsule.radius = farthest_distance(own[c], capsule.from, capsule.to);
      double cost = standoff_cost(capsule, voxels);
      for (int k = 0; k < kMovesPerRound; ++k) {  // both ends or one; last, to a sphere
        CapsuleBody moved = capsule;
        if (k % 4 != 3) moved.from += move_m * random.normal_vector3();
        if (k % 4 != 2) moved.to += move_m * random.normal_vector3();
        if (k == kMovesPerRound - 1) moved.from = moved.to;
        moved.radius = farthest_distance(own[c], moved.from, moved.to);
        const double moved_cost = standoff_cost(moved, voxels);
        if (!(moved_cost < cost)) continue;
        capsule = moved;
        cost = moved_cost;
      }
    }
    move_m *= kMoveFactor;
  }
}

Vec3 mean_point(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points) mean += point / static_cast<double>(points.size());
  return mean;
}

/// Splits points by the plane through their mean perpendicular to their principal axis.
std::array<std::vector<Vec3>, 2> halves(const std::vector<Vec3>& points) {
  const Vec3 mean = mean_point(points);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : points) spread += (point - mean) * (point - mean).transpose();
  const Vec3 axis = math::principal_axes(spread).axes.col(2);
  std::array<std::vector<Vec3>, 2> parts;
  for (const Vec3& point : points) parts[axis.dot(point - mean) > 0 ? 1 : 0].push_back(point);
  return parts;
}

/// Returns a capsule along the principal axis of points that encloses them.
CapsuleBody enclosing_capsule(const std::vector<Vec3>& points) {
  const Vec3 mean = mean_point(points);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : points)
    spread += (point - mean) * (point - mean).transpose() / static_cast<double>(points.size());
  const math::PrincipalAxes principal = math::principal_axes(spread);
  const Vec3 half =
      std::sqrt(std::max(0.0, principal.moments[2] - principal.moments[1])) * principal.axes.col(2);
  CapsuleBody capsule{mean - half, mean + half, 0};
  capsule.radius = farthest_distance(points, capsule.from, capsule.to);
  return capsule;
}

/// Splits capsules in two within the budget, at no higher cost; returns true if it split any.
bool split(std::vector<CapsuleBody>& capsules, const std::vector<Vec3>& points,
           const Voxels& voxels, int budget) {
  const std::vector<std::vector<Vec3>> own = assign_points(capsules, points);
  std::vector<int> order;
  std::vector<double> cost;
  for (int c = 0; c < std::ssize(capsules); ++c) {
    cost.push_back(standoff_cost(capsules[c], voxels));
    if (std::ssize(own[c]) >= kMinSplitPoints) order.push_back(c);
  }
  std::ranges::stable_sort(order, std::greater<>(), [&](int c) { return cost[c]; });
  const std::size_t before = capsules.size();
  for (const int c : order) {
    if (std::ssize(capsules) == budget) break;
    const auto parts = halves(own[c]);
    if (parts[0].empty() || parts[1].empty()) continue;
    const CapsuleBody one = enclosing_capsule(parts[0]), other = enclosing_capsule(parts[1]);
    if (standoff_cost(one, voxels) + standoff_cost(other, voxels) > cost[c]) continue;
    capsules[c] = one;
    capsules.push_back(other);
  }
  return capsules.size() > before;
}

/// Sets the smallest radii that enclose all points, plus a margin; removes capsules without points.
void enclose_points(std::vector<CapsuleBody>& capsules, const std::vector<Vec3>& points) {
  const std::vector<std::vector<Vec3>> own = assign_points(capsules, points);
  std::vector<CapsuleBody> used;
  for (int c = 0; c < std::ssize(capsules); ++c) {
    if (own[c].empty()) continue;
    used.push_back(capsules[c]);
    used.back().radius =
        farthest_distance(own[c], capsules[c].from, capsules[c].to) + kRadiusMargin_m;
  }
  capsules = std::move(used);
}

FitQuality fit_quality(const std::vector<CapsuleBody>& capsules,
                       const std::vector<Triangle>& surface, const Voxels& voxels,
                       const std::string& name) {
  FitQuality quality;
  int inside = 0;
  std::vector<Vec3> samples = sample_area(surface, kQualitySampleCount, name + "/judges");
  for (const Vec3& corner : outermost_corners(surface)) samples.push_back(corner);
  for (const Vec3& point : samples) {
    const double gap_m = union_signed_distance(capsules, point);
    inside += gap_m <= 0;
    quality.largest_gap_m = std::max(quality.largest_gap_m, gap_m);
  }
  quality.coverage = inside / static_cast<double>(samples.size());
  std::vector<double> standoffs;
  for (const CapsuleBody& capsule : capsules) {
    for (const Vec3& point : sample_capsule_surface(capsule, kQualityRings, kQualityRingPoints))
      if (union_signed_distance(capsules, point) > -kOuterDepth_m)
        standoffs.push_back(voxels.outside_distance(point));
  }
  if (standoffs.empty()) return quality;
  std::ranges::sort(standoffs);
  quality.standoff_median_m = math::lower_quantile(standoffs, 0.5);
  quality.standoff_95_m = math::lower_quantile(standoffs, 0.95);
  const auto end = std::ranges::upper_bound(standoffs, kNear_m);
  quality.near_share =
      static_cast<double>(end - standoffs.begin()) / static_cast<double>(standoffs.size());
  return quality;
}

/// Returns the bodies if they are spheres and capsules (cylinders with both end spheres), else {}.
std::vector<CapsuleBody> exact_capsules(const std::vector<SceneObject>& bodies) {
  std::vector<CapsuleBody> capsules, balls;
  for (const SceneObject& body : bodies) {
    const Pose pose = make_pose(body.position[0], body.orientation[0]);
    const double half =
        body.shape == Shape::sphere ? 0 : 0.5 * (body.size.size() > 1 ? body.size[1] : 0);
    const CapsuleBody own{pose * Vec3(0, 0, -half), pose * Vec3(0, 0, half),
                          body.size.empty() ? 0 : body.size[0]};
    if (body.shape == Shape::sphere)
      balls.push_back(own);
    else if (body.shape == Shape::capsule || body.shape == Shape::cylinder)
      capsules.push_back(own);
    else
      return {};
  }
  const auto ball_at = [&](const Vec3& centre, double radius) {
    return std::ranges::any_of(balls, [&](const CapsuleBody& ball) {
      return (ball.from - centre).norm() < kSameLength_m &&
             std::abs(ball.radius - radius) < kSameLength_m;
    });
  };
  for (const SceneObject& body : bodies) {
    if (body.shape != Shape::cylinder) continue;
    const Pose pose = make_pose(body.position[0], body.orientation[0]);
    const Vec3 half(0, 0, 0.5 * body.size[1]);
    if (!ball_at(pose * half, body.size[0]) || !ball_at(pose * Vec3(-half), body.size[0]))
      return {};
  }
  for (const CapsuleBody& ball : balls) {
    const bool hidden = std::ranges::any_of(capsules, [&](const CapsuleBody& c) {
      return distance_to_segment(ball.from, c.from, c.to) + ball.radius <= c.radius + kSameLength_m;
    });
    if (!hidden) capsules.push_back(ball);
  }
  return capsules;
}

}  // namespace

CapsuleFit fit_capsules(const std::vector<SceneObject>& bodies, int budget,
                        const std::string& name) {
  CapsuleFit cover;
  cover.capsules = exact_capsules(bodies);
  if (!cover.capsules.empty() && std::ssize(cover.capsules) <= budget) return cover;
  const std::vector<Triangle> surface = surface_of(bodies);
  if (surface.empty()) return cover;
  const Voxels voxels =
      voxels_of(sample_area(surface, kVoxelSampleCount, name + "/dense"), kCellsOnLongestSide);
  std::vector<Vec3> points = sample_area(surface, kFitSampleCount, name);
  for (const Vec3& corner : outermost_corners(surface)) points.push_back(corner);
  double min_cost = kInfinity;
  for (const int deep_thirds : {1, 2, 3}) {
    std::vector<CapsuleBody> capsules =
        choose_segments(voxels, points, deep_thirds, budget,
                        voxels.step_m * (kCellsOnLongestSide + 1) * std::sqrt(3.0), name);
    refine(capsules, points, voxels, name);
    while (std::ssize(capsules) < budget && split(capsules, points, voxels, budget))
      refine(capsules, points, voxels, name);
    enclose_points(capsules, points);
    const double cost = mean_square_standoff(capsules, voxels);
    if (cost < min_cost) cover.capsules = std::move(capsules);
    min_cost = std::min(min_cost, cost);
  }
  std::vector<Vec3> enclosed = sample_area(surface, kEnclosedSampleCount, name + "/held");
  enclosed.insert(enclosed.end(), points.begin(), points.end());
  enclose_points(cover.capsules, enclosed);
  cover.quality = fit_quality(cover.capsules, surface, voxels, name);
  return cover;
}

}  // namespace morphe::cover
