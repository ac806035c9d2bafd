#include "core/cover/fit_capsules.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/collision/mesh_solid.hpp"
#include "core/cover/capsule_surface.hpp"
#include "core/cover/choose_segments.hpp"
#include "core/cover/constants.hpp"
#include "core/cover/cover_primitives.hpp"
#include "core/cover/surface.hpp"
#include "core/cover/voxels.hpp"
#include "core/math/random_stream.hpp"
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

/// Returns points on the surface, its outermost corners, and points inside.
std::vector<Vec3> points_of(const std::vector<Triangle>& surface, const Voxels& voxels, int count,
                            const std::string& name) {
  std::vector<Vec3> points = sample_area(surface, count, name);
  for (const Vec3& corner : outermost_corners(surface)) points.push_back(corner);
  const std::vector<Vec3> inside = points_inside(voxels);
  const int inner = count / kSurfacePerInnerPoint;
  for (int k = 0; k < inner; ++k)
    points.push_back(
        inside[inside.size() * static_cast<std::size_t>(k) / static_cast<std::size_t>(inner)]);
  return points;
}

/// Sets the standoffs of the capsules' outer surface from the body, by a distance from it.
void judge_standoffs(const std::vector<CapsuleBody>& capsules,
                     const std::function<double(const Vec3&)>& distance_m, FitQuality& quality) {
  std::vector<double> standoffs;
  for (const CapsuleBody& capsule : capsules) {
    for (const Vec3& point : sample_capsule_surface(capsule, kQualityRings, kQualityRingPoints))
      if (union_signed_distance(capsules, point) > -kOuterDepth_m)
        standoffs.push_back(distance_m(point));
  }
  if (standoffs.empty()) return;
  std::ranges::sort(standoffs);
  quality.standoff_median_m = math::lower_quantile(standoffs, 0.5);
  quality.standoff_95_m = math::lower_quantile(standoffs, 0.95);
  const auto end = std::ranges::upper_bound(standoffs, kNear_m);
  quality.near_share =
      static_cast<double>(end - standoffs.begin()) / static_cast<double>(standoffs.size());
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
  const collision::MeshSolid mesh = collision::make_mesh_solid(mesh_of(surface));
  const auto standoff_m = [&](const Vec3& point) {
    Vec3 gradient;
    return voxels.outside_distance(point) > 0 ? collision::mesh_distance(mesh, point, gradient) : 0;
  };
  judge_standoffs(capsules, standoff_m, quality);
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

int enclosed_sample_count(const std::vector<Triangle>& surface) {
  const double wanted = area_of(surface) / kEnclosedSampleArea_m2;
  return static_cast<int>(std::clamp<double>(wanted, kMinEnclosedSamples, kMaxEnclosedSamples));
}

/// Sets the radii so that they enclose the points of the search and many others.
void enclose_surface(std::vector<CapsuleBody>& capsules, const std::vector<Triangle>& surface,
                     const Voxels& voxels, const std::vector<Vec3>& points,
                     const std::string& name) {
  std::vector<Vec3> enclosed =
      points_of(surface, voxels, enclosed_sample_count(surface), name + "/held");
  enclosed.insert(enclosed.end(), points.begin(), points.end());
  enclose_points(capsules, enclosed);
}

/// Returns the grid for a fit: with bodies nearby, as far as these must be known, and so fine that
/// the gap to them is several voxels wide.
Voxels grid_for(const std::vector<Triangle>& surface, const FitOptions& options) {
  const Voxels plain = voxels_of(surface, kCellsOnLongestSide, options.aim_m);
  if (options.nearby.empty()) return plain;
  const double wanted =
      kCellsOnLongestSide * plain.step_m * kCellsAcrossGap / std::max(options.gap_m, kMinStep_m);
  const int cells =
      static_cast<int>(std::clamp<double>(wanted, kCellsOnLongestSide, kMaxCellsOnLongestSide));
  return voxels_of(surface, cells, 2 * options.aim_m + options.clearance_m);
}

/// Removes capsules that lie inside another one, as they do if both their ends do.
void remove_contained(std::vector<CapsuleBody>& capsules) {
  const auto contains = [](const CapsuleBody& outer, const CapsuleBody& inner) {
    const double depth_m = outer.radius - inner.radius;
    return distance_to_segment(inner.from, outer.from, outer.to) <= depth_m &&
           distance_to_segment(inner.to, outer.from, outer.to) <= depth_m;
  };
  for (std::size_t k = capsules.size(); k-- > 0;) {
    const auto outer = std::ranges::find_if(capsules, [&](const CapsuleBody& other) {
      return &other != &capsules[k] && contains(other, capsules[k]);
    });
    if (outer != capsules.end()) capsules.erase(capsules.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

}  // namespace

CapsuleFit fit_capsules(const std::vector<SceneObject>& bodies, const FitOptions& options,
                        const std::string& name) {
  CapsuleFit cover;
  cover.capsules = exact_capsules(bodies);
  if (!cover.capsules.empty() && std::ssize(cover.capsules) <= options.budget) return cover;
  cover.capsules.clear();
  if (options.nearby.empty()) cover.capsules = cover_primitives(bodies, options.budget);
  if (!cover.capsules.empty()) {
    judge_standoffs(
        cover.capsules, [&](const Vec3& point) { return distance_from_primitives(bodies, point); },
        cover.quality);
    return cover;
  }
  const std::vector<Triangle> surface = surface_of(bodies);
  if (surface.empty()) return cover;
  const Voxels voxels = grid_for(surface, options);
  const std::vector<Vec3> points = points_of(surface, voxels, kFitSampleCount, name);
  const std::vector<Vec3> directions = main_directions(surface);
  StandoffLimits limits{options.aim_m - 0.5 * voxels.step_m, {}};
  Segments chosen;
  if (!options.nearby.empty()) {
    limits.forbidden =
        voxels_nearer_to(options.nearby, options.clearance_m + voxels.step_m, voxels);
    chosen = choose_segments(voxels, points, directions, options.budget, limits, name);
    limits.forbidden.clear();
  }
  if (chosen.capsules.empty())
    chosen = choose_segments(voxels, points, directions, options.budget, limits, name);
  cover.capsules = std::move(chosen.capsules);
  if (chosen.growth_m > limits.aim_m) {
    enclose_points(cover.capsules, points);
    refine(cover.capsules, points, voxels, name);
  }
  enclose_surface(cover.capsules, surface, voxels, points, name);
  remove_contained(cover.capsules);
  cover.quality = fit_quality(cover.capsules, surface, voxels, name);
  return cover;
}

}  // namespace morphe::cover
