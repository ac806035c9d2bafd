#include "stages/verify/convex_gap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace morphe::verify {
namespace {

constexpr double kGapAccuracy_m = 1e-9, kSamePoint_m = 1e-12;
constexpr int kMaxWolfeSteps = 300, kMaxClimbSteps = 1000;
/// Directions over the whole sphere at which the search for a depth begins, and its first and last
/// step [rad]: with 300 directions a quarter of their spacing, and 1e-9 m on a body of a metre.
constexpr int kFirstDirections = 300;
constexpr double kFirstTurn_rad = 0.05, kLastTurn_rad = 1e-9;

/// Returns by how much a body extends beyond its core: the radius of a sphere or capsule.
double roundness(const ConvexShape& body) {
  const bool round =
      body.object && (body.object->shape == Shape::sphere || body.object->shape == Shape::capsule);
  return round ? body.object->size[0] : 0;
}

/// Returns the point of a body's core that lies farthest in a direction.
Vec3 farthest_point(const ConvexShape& body, const Vec3& direction) {
  if (!body.object) {
    const auto height = [&](const Vec3& corner) { return direction.dot(corner); };
    return *std::ranges::max_element(body.corners, {}, height);
  }
  const std::vector<double>& size = body.object->size;
  const Vec3 local = body.pose.linear().transpose() * direction;
  const auto half = [](double sign, double length) { return std::copysign(0.5 * length, sign); };
  Vec3 point = Vec3::Zero();
  if (body.object->shape == Shape::box)
    point = Vec3(half(local.x(), size[0]), half(local.y(), size[1]), half(local.z(), size[2]));
  if (body.object->shape == Shape::cylinder || body.object->shape == Shape::capsule)
    point.z() = half(local.z(), size[1]);
  const double across = std::hypot(local.x(), local.y());
  if (body.object->shape == Shape::cylinder && across > 0)
    point += size[0] / across * Vec3(local.x(), local.y(), 0);
  return body.pose * point;
}

Vec3 farthest_difference(const ConvexShape& a, const ConvexShape& b, const Vec3& direction) {
  return farthest_point(a, direction) - farthest_point(b, -direction);
}

/// Solves a small linear system by elimination with pivots; returns false if it is singular.
bool solve(std::array<std::array<double, 5>, 4>& rows, int n, std::array<double, 4>& x) {
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
    if (!(std::abs(rows[pivot][k]) > 1e-30)) return false;
    std::swap(rows[k], rows[pivot]);
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = rows[i][k] / rows[k][k];
      for (int j = k; j < 5; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  for (int k = 0; k < n; ++k) x[k] = rows[k][4] / rows[k][k];
  return true;
}

/// Points whose combination with `weights` is the nearest to the origin found so far.
struct Corral {
  std::vector<Vec3> points;
  std::vector<double> weights;

  Vec3 combination() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * points[i];
    return sum;
  }

  /// Returns the weights of the affine combination of least norm; empty if they are not unique.
  std::vector<double> affine_weights() const {
    const int n = static_cast<int>(points.size()) - 1;
    std::array<std::array<double, 5>, 4> rows{};
    std::array<double, 4> x{};
    for (int i = 0; i < n; ++i) {
      const Vec3 edge = points[i + 1] - points[0];
      for (int j = 0; j < n; ++j) rows[i][j] = edge.dot(points[j + 1] - points[0]);
      rows[i][4] = -edge.dot(points[0]);
    }
    if (n > 3 || !solve(rows, n, x)) return {};
    std::vector<double> found{1};
    for (int i = 0; i < n; ++i) {
      found.push_back(x[i]);
      found[0] -= x[i];
    }
    return found;
  }

  /// Moves the combination to the nearest point of the points' hull; returns false on failure.
  bool reduce() {
    while (true) {
      const std::vector<double> wanted = affine_weights();
      if (wanted.empty()) return false;
      double share = 1;
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i] <= 0) share = std::min(share, weights[i] / (weights[i] - wanted[i]));
      for (std::size_t i = 0; i < wanted.size(); ++i)
        weights[i] += share * (wanted[i] - weights[i]);
      if (share == 1) return true;
      const auto smallest = std::ranges::min_element(weights) - weights.begin();
      weights.erase(weights.begin() + smallest);
      points.erase(points.begin() + smallest);
    }
  }
};

/// Returns the direction, not normalised, from b to a in which the cores are farthest apart.
Vec3 separating_direction(const ConvexShape& a, const ConvexShape& b) {
  Corral corral{{farthest_difference(a, b, Vec3::UnitX())}, {1}};
  Vec3 nearest = corral.points[0], best = nearest;
  double best_gap = -kInfinity;
  for (int step = 0; step < kMaxWolfeSteps && nearest.norm() > kSamePoint_m; ++step) {
    const double length = nearest.norm();
    const Vec3 next = farthest_difference(a, b, -nearest);
    const double gap = next.dot(nearest) / length;
    if (gap > best_gap) {
      best_gap = gap;
      best = nearest;
    }
    if (length - best_gap <= kGapAccuracy_m) break;
    corral.points.push_back(next);
    corral.weights.push_back(0);
    if (!corral.reduce()) break;
    nearest = corral.combination();
  }
  return best;
}

/// Returns the gap of the planes with a normal; minus infinity if it has no direction.
double gap_along(const ConvexShape& a, const ConvexShape& b, const Vec3& normal) {
  const double length = normal.norm();
  if (!(length > kSamePoint_m)) return -kInfinity;
  const Vec3 direction = normal / length;
  return farthest_difference(a, b, -direction).dot(direction) - roundness(a) - roundness(b);
}

/// Turns the direction of a gap towards larger ones, by ever smaller angles; returns the gap.
double climb(const ConvexShape& a, const ConvexShape& b, Vec3 direction) {
  double gap = gap_along(a, b, direction);
  direction.normalize();
  double turn = kFirstTurn_rad;
  for (int step = 0; step < kMaxClimbSteps && turn > kLastTurn_rad; ++step, turn *= 0.5) {
    const Vec3 side = direction.unitOrthogonal(), other = direction.cross(side);
    for (int k = 0; k < 8; ++k) {
      const double angle = k * std::numbers::pi / 4;
      const Vec3 tried =
          (direction + turn * (std::cos(angle) * side + std::sin(angle) * other)).normalized();
      const double value = gap_along(a, b, tried);
      if (value <= gap) continue;
      gap = value;
      direction = tried;
      turn *= 2;
      break;
    }
  }
  return gap;
}

void add_axes(const ConvexShape& body, std::vector<Vec3>& directions) {
  if (!body.object) {
    const Vec3 first = body.corners[1] - body.corners[0],
               second = body.corners[2] - body.corners[0];
    directions.push_back(first.cross(second));
    return;
  }
  for (int axis = 0; axis < 3; ++axis) directions.push_back(body.pose.linear().col(axis));
}

std::vector<Vec3> edges_of(const ConvexShape& body) {
  if (body.object)
    return {body.pose.linear().col(0), body.pose.linear().col(1), body.pose.linear().col(2)};
  return {body.corners[1] - body.corners[0], body.corners[2] - body.corners[1],
          body.corners[0] - body.corners[2]};
}

double overlap_gap(const ConvexShape& a, const ConvexShape& b) {
  std::vector<Vec3> directions;
  add_axes(a, directions);
  add_axes(b, directions);
  for (const Vec3& edge : edges_of(a))
    for (const Vec3& other : edges_of(b)) directions.push_back(edge.cross(other));
  for (std::size_t k = 0, axes = directions.size(); k < axes; ++k)
    directions.push_back(-directions[k]);
  const bool triangle = !a.object || !b.object;  // one of many, for which the others are enough
  for (int k = 0; k < (triangle ? 0 : kFirstDirections); ++k) {
    const double z = 1 - (2 * k + 1.0) / kFirstDirections,
                 turn = 2 * std::numbers::pi * std::numbers::phi * k;
    const double across = std::sqrt(1 - z * z);
    directions.emplace_back(across * std::cos(turn), across * std::sin(turn), z);
  }
  const auto gap = [&](const Vec3& direction) { return gap_along(a, b, direction); };
  const Vec3 best = *std::ranges::max_element(directions, {}, gap);
  return triangle ? gap(best) : climb(a, b, best);
}

}  // namespace

double convex_gap(const ConvexShape& a, const ConvexShape& b) {
  const double gap = gap_along(a, b, separating_direction(a, b));
  return gap + roundness(a) + roundness(b) > 0 ? gap : overlap_gap(a, b);
}

}  // namespace morphe::verify
