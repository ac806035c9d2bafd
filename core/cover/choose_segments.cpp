#include "core/cover/choose_segments.hpp"

#include <algorithm>
#include <limits>

#include "core/cover/capsule_surface.hpp"
#include "core/cover/constants.hpp"
#include "core/math/random_stream.hpp"

namespace morphe::cover {
namespace {

using collision::CapsuleBody;

/// Segments inside the body, and the distance of every point from each of them.
struct Segments {
  std::vector<CapsuleBody> bodies;  ///< radius: smallest distance from the surface along it
  std::vector<float> distance;      ///< [segments, points]
};

std::vector<Vec3> points_inside(const Voxels& voxels) {
  std::vector<Vec3> inside;
  for (int z = 0; z < voxels.count.z(); ++z) {
    for (int y = 0; y < voxels.count.y(); ++y) {
      for (int x = 0; x < voxels.count.x(); ++x)
        if (voxels.inside[voxels.index(x, y, z)]) inside.push_back(voxels.centre(x, y, z));
    }
  }
  return inside;
}

/// Returns the depth of a point of the grid below the surface, < 0 outside [m].
double depth(const Voxels& voxels, const Vec3& point) {
  const Eigen::Vector3i at = ((point - voxels.origin) / voxels.step_m).cast<int>();
  const std::ptrdiff_t cell = voxels.index(at.x(), at.y(), at.z());
  return voxels.inside[cell] ? voxels.distance[cell] : -voxels.distance[cell];
}

/// Returns the deepest of `draws` random interior points: with more, nearer to the medial axis.
Vec3 draw_inside(const Voxels& voxels, const std::vector<Vec3>& inside, int draws,
                 math::RandomStream& random) {
  Vec3 deepest = inside.front();
  double max_depth_m = -1;
  for (int k = 0; k < draws; ++k) {
    const Vec3& point =
        inside[static_cast<std::size_t>(random.uniform() * static_cast<double>(inside.size()))];
    const double depth_m = depth(voxels, point);
    if (depth_m > max_depth_m) deepest = point;
    max_depth_m = std::max(max_depth_m, depth_m);
  }
  return deepest;
}

Segments draw_segments(const Voxels& voxels, const std::vector<Vec3>& points, int deep_thirds,
                       const std::string& name) {
  Segments segments;
  const std::vector<Vec3> inside = points_inside(voxels);
  math::RandomStream random(2, name);
  for (int k = 0;
       std::ssize(segments.bodies) < kCandidateCount && k < kMaxDrawsPerCandidate * kCandidateCount;
       ++k) {
    const int draws = k % 3 < deep_thirds ? kDeepDraws : 1;
    CapsuleBody body{draw_inside(voxels, inside, draws, random),
                     draw_inside(voxels, inside, draws, random), kInfinity};
    if (k % kSpherePeriod == 0) body.to = body.from;
    const int steps = 1 + static_cast<int>((body.to - body.from).norm() / voxels.step_m);
    for (int step = 0; step <= steps && body.radius >= 0; ++step) {
      const double t = static_cast<double>(step) / steps;
      body.radius = std::min(body.radius, depth(voxels, body.from + t * (body.to - body.from)));
    }
    if (body.radius >= 0) segments.bodies.push_back(body);
  }
  segments.distance.reserve(segments.bodies.size() * points.size());
  for (const CapsuleBody& body : segments.bodies) {
    for (const Vec3& point : points) {
      segments.distance.push_back(
          static_cast<float>(distance_to_segment(point, body.from, body.to)));
    }
  }
  return segments;
}

/// Chooses segments greedily that cover all points at a growth; empty if over `budget` are needed.
std::vector<int> cover_greedily(const Segments& segments, std::ptrdiff_t points, double growth_m,
                                int budget) {
  std::vector<float> covered(points, 0);  // added to distances: infinity once covered
  std::ptrdiff_t uncovered = points;
  std::vector<int> choice;
  // Upper bounds of the number of points that a segment adds: they only fall, and save evaluations.
  std::vector<int> max_added(segments.bodies.size(), std::numeric_limits<int>::max());
  const auto distances = [&](int s) { return segments.distance.data() + s * points; };
  const auto grown_radius = [&](int s) {
    return static_cast<float>(segments.bodies[s].radius + growth_m);
  };
  while (uncovered > 0 && std::ssize(choice) < budget) {
    int best_segment = 0, max_gain = 0;
    for (int s = 0; s < std::ssize(segments.bodies); ++s) {
      if (max_added[s] <= max_gain) continue;
      const float radius_m = grown_radius(s);
      const float* distance = distances(s);
      int added = 0;
      for (std::ptrdiff_t p = 0; p < points; ++p) added += distance[p] + covered[p] <= radius_m;
      max_added[s] = added;
      if (added > max_gain) {
        max_gain = added;
        best_segment = s;
      }
    }
    if (max_gain == 0) return {};
    for (std::ptrdiff_t p = 0; p < points; ++p)
      if (distances(best_segment)[p] + covered[p] <= grown_radius(best_segment))
        covered[p] = std::numeric_limits<float>::infinity();
    uncovered -= max_gain;
    choice.push_back(best_segment);
  }
  return uncovered == 0 ? choice : std::vector<int>{};
}

}  // namespace

std::vector<CapsuleBody> choose_segments(const Voxels& voxels, const std::vector<Vec3>& points,
                                         int deep_thirds, int budget, double max_growth_m,
                                         const std::string& name) {
  const Segments segments = draw_segments(voxels, points, deep_thirds, name);
  double low = 0, high = max_growth_m;
  std::vector<int> chosen = cover_greedily(segments, std::ssize(points), high, budget);
  for (int k = 0; k < kGrowthBisectionCount; ++k) {
    const double growth = 0.5 * (low + high);
    std::vector<int> choice = cover_greedily(segments, std::ssize(points), growth, budget);
    if (choice.empty()) {
      low = growth;
    } else {
      high = growth;
      chosen = std::move(choice);
    }
  }
  std::vector<CapsuleBody> capsules;
  for (const int s : chosen) capsules.push_back(segments.bodies[s]);
  for (CapsuleBody& capsule : capsules) capsule.radius += high;
  return capsules;
}

}  // namespace morphe::cover
