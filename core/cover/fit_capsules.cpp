#include "core/cover/fit_capsules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/cover/surface.hpp"
#include "core/cover/voxels.hpp"
#include "core/math/random_stream.hpp"
#include "core/math/rotation.hpp"
#include "core/math/statistics.hpp"

namespace morphe::cover {
namespace {

using collision::CapsuleBody;

constexpr int kCellsOnLongestSide = 72;              ///< voxels along the longest side
constexpr std::size_t kVoxelSampleCount = 150000;    ///< points that mark voxels of the surface
constexpr std::size_t kFitSampleCount = 3000;        ///< points that must be enclosed
constexpr std::size_t kEnclosedSampleCount = 60000;  ///< points that the final radii must enclose
constexpr std::size_t kQualitySampleCount = 12000;   ///< points for the quality
constexpr std::size_t kCandidateCount = 1600;        ///< candidate segments
constexpr int kGrowthBisectionCount = 12;            ///< bisection steps of the growth
constexpr int kRefineRoundCount = 60;                ///< rounds of moving the ends
constexpr double kRadiusMargin_m = 2e-4;             ///< for the surface between samples

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 axis = to - from;
  const double length = axis.squaredNorm();
  const double t = length > 0 ? std::clamp((point - from).dot(axis) / length, 0.0, 1.0) : 0;
  return (point - from - t * axis).norm();
}

/// Segments inside the body with their clearance, and the distance of every point from each of
/// them.
struct Segments {
  std::vector<CapsuleBody> bodies;  ///< radius: smallest distance from the surface along it
  std::vector<float> distance;      ///< [segments, points]
};

std::vector<Vec3> points_inside(const Voxels& voxels) {
  std::vector<Vec3> inside;
  for (int z = 0; z < voxels.count.z(); ++z) {
    for (int y = 0; y < voxels.count.y(); ++y) {
      for (int x = 0; x < voxels.count.x(); ++x) {
        if (voxels.inside[voxels.index(x, y, z)]) inside.push_back(voxels.centre(x, y, z));
      }
    }
  }
  return inside;
}

/// Returns the distance of an interior point from the surface, < 0 outside.
double depth(const Voxels& voxels, const Vec3& point) {
  const Eigen::Vector3i at = ((point - voxels.origin) / voxels.step_m).cast<int>();
  const std::size_t cell = voxels.index(at.x(), at.y(), at.z());
  return voxels.inside[cell] ? voxels.distance[cell] : -voxels.distance[cell];
}

/// Returns the deepest of a few random points: the more points, the nearer to the body's medial
/// axis.
Vec3 draw_inside(const Voxels& voxels, const std::vector<Vec3>& inside, int few,
                 math::RandomStream& random) {
  Vec3 best = inside.front();
  double deepest = -1;
  for (int k = 0; k < few; ++k) {
    const auto at = static_cast<std::size_t>(random.uniform() * static_cast<double>(inside.size()));
    const double here = depth(voxels, inside[at]);
    if (here > deepest) best = inside[at];
    deepest = std::max(deepest, here);
  }
  return best;
}

/// Draws random segments, `deep` thirds of them near the medial axis.
Segments draw_segments(const Voxels& voxels, const std::vector<Vec3>& points, std::size_t deep,
                       const std::string& name) {
  Segments segments;
  const std::vector<Vec3> inside = points_inside(voxels);
  math::RandomStream random(2, name);
  for (std::size_t tries = 0;
       segments.bodies.size() < kCandidateCount && tries < 8 * kCandidateCount; ++tries) {
    const int few = tries % 3 < deep ? 3 : 1;
    CapsuleBody body{draw_inside(voxels, inside, few, random),
                     draw_inside(voxels, inside, few, random), 0};
    if (tries % 4 == 0) body.to = body.from;  // includes spheres
    double least = std::numeric_limits<double>::infinity();
    const int steps = 1 + static_cast<int>((body.to - body.from).norm() / voxels.step_m);
    for (int k = 0; k <= steps && least >= 0; ++k) {
      const double share = static_cast<double>(k) / steps;
      least = std::min(least, depth(voxels, body.from + share * (body.to - body.from)));
    }
    if (least < 0) continue;
    body.radius = least;
    segments.bodies.push_back(body);
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

/// Chooses segments greedily that cover all points at a given growth; empty if more than `most` are
/// needed.
std::vector<std::size_t> greedy_set_cover(const Segments& segments, std::size_t points,
                                          double growth_m, std::size_t most) {
  constexpr float kCovered = std::numeric_limits<float>::infinity();
  // Infinite for covered points, so that they are out of reach.
  std::vector<float> covered(points, 0);
  std::size_t left = points;
  std::vector<std::size_t> choice;
  // Upper bounds of the number of points that a segment adds. They only decrease, so segments whose
  // bound does not exceed the best need not be evaluated.
  std::vector<std::int32_t> at_most(segments.bodies.size(),
                                    std::numeric_limits<std::int32_t>::max());
  while (left > 0 && choice.size() < most) {
    std::size_t best = 0;
    std::int32_t gain = 0;
    for (std::size_t s = 0; s < segments.bodies.size(); ++s) {
      if (at_most[s] <= gain) continue;
      const auto reach = static_cast<float>(segments.bodies[s].radius + growth_m);
      const float* distance = segments.distance.data() + s * points;
      std::int32_t fresh = 0;
      for (std::size_t p = 0; p < points; ++p) fresh += distance[p] + covered[p] <= reach;
      at_most[s] = fresh;
      if (fresh > gain) {
        gain = fresh;
        best = s;
      }
    }
    if (gain == 0) return {};
    const auto reach = static_cast<float>(segments.bodies[best].radius + growth_m);
    for (std::size_t p = 0; p < points; ++p) {
      if (segments.distance[best * points + p] + covered[p] <= reach) covered[p] = kCovered;
    }
    left -= gain;
    choice.push_back(best);
  }
  return left == 0 ? choice : std::vector<std::size_t>{};
}

std::vector<CapsuleBody> least_growth_cover(const Segments& segments, std::size_t points,
                                            int budget, double extent_m) {
  double low = 0, high = extent_m;
  std::vector<std::size_t> best = greedy_set_cover(segments, points, high, budget);
  for (int k = 0; k < kGrowthBisectionCount; ++k) {
    const double growth = 0.5 * (low + high);
    std::vector<std::size_t> choice = greedy_set_cover(segments, points, growth, budget);
    if (choice.empty()) {
      low = growth;
    } else {
      high = growth;
      best = std::move(choice);
    }
  }
  std::vector<CapsuleBody> capsules;
  for (const std::size_t s : best) capsules.push_back(segments.bodies[s]);
  for (CapsuleBody& capsule : capsules) capsule.radius += high;
  return capsules;
}

/// Returns points distributed over a capsule's surface.
std::vector<Vec3> sample_capsule_surface(const CapsuleBody& capsule, int rings, int round) {
  const Vec3 way = capsule.to - capsule.from;
  const Vec3 z = way.norm() > 1e-9 ? Vec3(way.normalized()) : Vec3::UnitZ();
  const Vec3 x = z.unitOrthogonal(), y = z.cross(x);
  const double length = way.norm(), r = capsule.radius, whole = length + 2 * r;
  std::vector<Vec3> points;
  for (int k = 0; k < rings; ++k) {  // equal heights have equal areas on both sphere and cylinder
    const double h = whole * (k + 0.5) / rings - r;
    const double t = std::clamp(h, 0.0, length), up = h - t;
    const double across = std::sqrt(std::max(0.0, r * r - up * up));
    for (int i = 0; i < round; ++i) {
      const double a = 2 * M_PI * (i + 0.5 * (k % 2)) / round;
      points.emplace_back(capsule.from + h * z + across * (std::cos(a) * x + std::sin(a) * y));
    }
  }
  return points;
}

/// Returns the mean square distance of a capsule's surface from the body, multiplied by its area.
double cost_of(const CapsuleBody& capsule, const Voxels& voxels) {
  double sum = 0;
  int count = 0;
  for (const Vec3& point : sample_capsule_surface(capsule, 8, 10)) {
    const double off = voxels.outside_distance(point);
    sum += off * off;
    ++count;
  }
  const double length = (capsule.to - capsule.from).norm();
  const double area = 2 * M_PI * capsule.radius * (length + 2 * capsule.radius);
  return area * sum / count;
}

double farthest_distance(const std::vector<Vec3>& points, const Vec3& from, const Vec3& to) {
  double most = 0;
  for (const Vec3& point : points) most = std::max(most, distance_to_segment(point, from, to));
  return most;
}

/// Assigns every point to the capsule in which it is deepest.
std::vector<std::vector<Vec3>> assign_points(const std::vector<CapsuleBody>& capsules,
                                             const std::vector<Vec3>& points) {
  std::vector<std::vector<Vec3>> own(capsules.size());
  for (const Vec3& point : points) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < capsules.size(); ++c) {
      const double out =
          distance_to_segment(point, capsules[c].from, capsules[c].to) - capsules[c].radius;
      if (out < least) {
        least = out;
        best = c;
      }
    }
    own[best].push_back(point);
  }
  return own;
}

/// Moves the ends of each capsule at random as long as its cost decreases, with the smallest radius
/// that encloses its points.
void refine(std::vector<CapsuleBody>& capsules, const std::vector<Vec3>& points,
            const Voxels& voxels, const std::string& name) {
  math::RandomStream random(3, name);
  double step_m = 4 * voxels.step_m;
  for (int round = 0; round < kRefineRoundCount; ++round) {
    const std::vector<std::vector<Vec3>> own = assign_points(capsules, points);
    for (std::size_t c = 0; c < capsules.size(); ++c) {
      if (own[c].empty()) continue;
      CapsuleBody& capsule = capsules[c];
      capsule.radius = farthest_distance(own[c], capsule.from, capsule.to);
      double cost = cost_of(capsule, voxels);
      for (int k = 0; k < 8; ++k) {
        CapsuleBody moved = capsule;
        if (k % 4 != 3) moved.from += step_m * random.normal_vector3();
        if (k % 4 != 2) moved.to += step_m * random.normal_vector3();
        if (k == 7) moved.from = moved.to;
        moved.radius = farthest_distance(own[c], moved.from, moved.to);
        const double less = cost_of(moved, voxels);
        if (less < cost) {
          capsule = moved;
          cost = less;
        }
      }
    }
    step_m *= 0.93;
  }
}

/// Splits points by the plane through their mean perpendicular to their principal axis.
std::array<std::vector<Vec3>, 2> halves(const std::vector<Vec3>& points) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& point : points) middle += point / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : points) spread += (point - middle) * (point - middle).transpose();
  const Vec3 way = math::principal_axes(spread).axes.col(2);
  std::array<std::vector<Vec3>, 2> parts;
  for (const Vec3& point : points) parts[way.dot(point - middle) > 0 ? 1 : 0].push_back(point);
  return parts;
}

/// Returns a capsule that encloses points, along their principal axis.
CapsuleBody fit_capsule(const std::vector<Vec3>& points) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& point : points) middle += point / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : points)
    spread += (point - middle) * (point - middle).transpose() / static_cast<double>(points.size());
  const math::PrincipalAxes principal = math::principal_axes(spread);
  const Vec3 half =
      std::sqrt(std::max(0.0, principal.moments[2] - principal.moments[1])) * principal.axes.col(2);
  CapsuleBody capsule{middle - half, middle + half, 0};
  capsule.radius = farthest_distance(points, capsule.from, capsule.to);
  return capsule;
}

/// Uses the remaining budget: splits the capsules with the highest cost in two.
bool split(std::vector<CapsuleBody>& capsules, const std::vector<Vec3>& points,
           const Voxels& voxels, std::size_t budget) {
  const std::vector<std::vector<Vec3>> own = assign_points(capsules, points);
  std::vector<std::size_t> order;
  std::vector<double> cost;
  for (std::size_t c = 0; c < capsules.size(); ++c) {
    cost.push_back(cost_of(capsules[c], voxels));
    if (own[c].size() > 8) order.push_back(c);
  }
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t c) { return cost[c]; });
  const std::size_t before = capsules.size();
  for (const std::size_t c : order) {
    if (capsules.size() == budget) break;
    const auto parts = halves(own[c]);
    if (parts[0].empty() || parts[1].empty()) continue;
    const CapsuleBody one = fit_capsule(parts[0]), other = fit_capsule(parts[1]);
    if (cost_of(one, voxels) + cost_of(other, voxels) > cost[c]) continue;
    capsules[c] = one;
    capsules.push_back(other);
  }
  return capsules.size() > before;
}

/// Sets the smallest radii that enclose all points, and removes capsules without points.
void enclose_points(std::vector<CapsuleBody>& capsules, const std::vector<Vec3>& points) {
  const std::vector<std::vector<Vec3>> own = assign_points(capsules, points);
  std::vector<CapsuleBody> used;
  for (std::size_t c = 0; c < capsules.size(); ++c) {
    if (own[c].empty()) continue;
    capsules[c].radius =
        farthest_distance(own[c], capsules[c].from, capsules[c].to) + kRadiusMargin_m;
    used.push_back(capsules[c]);
  }
  capsules = std::move(used);
}

double union_signed_distance(const std::vector<CapsuleBody>& capsules, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const CapsuleBody& c : capsules) {
    least = std::min(least, distance_to_segment(point, c.from, c.to) - c.radius);
  }
  return least;
}

/// Returns the mean square distance of the capsules' outer surface from the body [m²].
double mean_square_standoff(const std::vector<CapsuleBody>& capsules, const Voxels& voxels) {
  double sum = 0, whole = 0;
  for (const CapsuleBody& capsule : capsules) {
    const std::vector<Vec3> points = sample_capsule_surface(capsule, 8, 10);
    const double length = (capsule.to - capsule.from).norm();
    const double area = 2 * M_PI * capsule.radius * (length + 2 * capsule.radius);
    for (const Vec3& point : points) {
      if (union_signed_distance(capsules, point) < -1e-6) continue;
      const double off = voxels.outside_distance(point);
      const double share = area / static_cast<double>(points.size());
      sum += share * off * off;
      whole += share;
    }
  }
  return whole > 0 ? sum / whole : 0;
}

FitQuality fit_quality(const std::vector<CapsuleBody>& capsules,
                       const std::vector<Triangle>& surface, const Voxels& voxels,
                       const std::string& name) {
  FitQuality figures;
  std::size_t inside = 0;
  std::vector<Vec3> judges = sample_area(surface, kQualitySampleCount, name + "/judges");
  for (const Vec3& corner : outermost_corners(surface)) judges.push_back(corner);
  for (const Vec3& point : judges) {
    const double out = union_signed_distance(capsules, point);
    inside += out <= 0;
    figures.largest_gap_m = std::max(figures.largest_gap_m, out);
  }
  figures.coverage = static_cast<double>(inside) / static_cast<double>(judges.size());
  std::vector<double> off;
  for (const CapsuleBody& capsule : capsules) {
    for (const Vec3& point : sample_capsule_surface(capsule, 16, 20)) {
      if (union_signed_distance(capsules, point) > -1e-6)
        off.push_back(voxels.outside_distance(point));
    }
  }
  if (off.empty()) return figures;
  std::ranges::sort(off);
  figures.standoff_median_m = math::lower_quantile(off, 0.5);
  figures.standoff_95_m = math::lower_quantile(off, 0.95);
  figures.near_share = static_cast<double>(std::ranges::upper_bound(off, 0.005) - off.begin()) /
                       static_cast<double>(off.size());
  return figures;
}

/// Returns spheres and capsules if the bodies consist only of these: a cylinder with a sphere at
/// both ends is a capsule.
std::vector<CapsuleBody> exact_capsules(const std::vector<SceneObject>& bodies) {
  std::vector<CapsuleBody> capsules;
  std::vector<CapsuleBody> balls;
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
  const auto ball_at = [&](const Vec3& at, double radius) {
    return std::ranges::any_of(balls, [&](const CapsuleBody& ball) {
      return (ball.from - at).norm() < 1e-9 && std::abs(ball.radius - radius) < 1e-9;
    });
  };
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].shape != Shape::cylinder) continue;
    const Pose pose = make_pose(bodies[k].position[0], bodies[k].orientation[0]);
    const Vec3 half(0, 0, 0.5 * bodies[k].size[1]);
    if (!ball_at(pose * half, bodies[k].size[0]) || !ball_at(pose * Vec3(-half), bodies[k].size[0]))
      return {};
  }
  for (const CapsuleBody& ball : balls) {
    const bool hidden = std::ranges::any_of(capsules, [&](const CapsuleBody& c) {
      return distance_to_segment(ball.from, c.from, c.to) + ball.radius <= c.radius + 1e-9;
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
  if (!cover.capsules.empty() && cover.capsules.size() <= static_cast<std::size_t>(budget)) {
    return cover;
  }
  const std::vector<Triangle> surface = surface_of(bodies);
  if (surface.empty()) return cover;
  const Voxels voxels =
      voxels_of(sample_area(surface, kVoxelSampleCount, name + "/dense"), kCellsOnLongestSide);
  std::vector<Vec3> points = sample_area(surface, kFitSampleCount, name);
  for (const Vec3& corner : outermost_corners(surface)) points.push_back(corner);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t deep : {1, 2, 3}) {
    std::vector<CapsuleBody> capsules =
        least_growth_cover(draw_segments(voxels, points, deep, name), points.size(), budget,
                           voxels.step_m * (kCellsOnLongestSide + 1) * std::sqrt(3.0));
    refine(capsules, points, voxels, name);
    while (capsules.size() < static_cast<std::size_t>(budget) &&
           split(capsules, points, voxels, budget)) {
      refine(capsules, points, voxels, name);
    }
    enclose_points(capsules, points);
    const double cost = mean_square_standoff(capsules, voxels);
    if (cost < least) cover.capsules = std::move(capsules);
    least = std::min(least, cost);
  }
  std::vector<Vec3> held = sample_area(surface, kEnclosedSampleCount, name + "/held");
  held.insert(held.end(), points.begin(), points.end());
  enclose_points(cover.capsules, held);
  cover.quality = fit_quality(cover.capsules, surface, voxels, name);
  return cover;
}

}  // namespace morphe::cover
