#include "stages/verify/wrench_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "stages/verify/hull_facets.hpp"

namespace morphe::verify {
namespace {

constexpr double kBoundGapRatio = 0.05, kMinBoundGap = 1e-3;
constexpr double kZeroTolerance = 1e-9;  ///< smaller values are rounding errors
constexpr int kInitialPointCount = 24, kStartCount = 64, kDescentCount = 6, kMaxPointsPerRound = 8;
constexpr double kMaxDirectionCosine = 0.95;
constexpr int kMaxHullRounds = 60, kMaxHullPoints = 400;
constexpr int kMaxGilbertSteps = 20000;

/// Returns the difference of two bounds, of which one has this value, that is small enough.
double tolerated_gap(double value) {
  return std::max(kMinBoundGap, kBoundGapRatio * std::abs(value));
}

bool is_tight(const Bounds& b) {
  return std::isfinite(b.lower) && b.upper - b.lower <= tolerated_gap(b.lower);
}

/// Returns true if the bounds found agree with the claimed ones to the requested accuracy.
bool confirms_claim(const Bounds& found, const Bounds& claimed) {
  if (!std::isfinite(claimed.lower) || !std::isfinite(claimed.upper)) return false;
  const double gap = tolerated_gap(claimed.lower);
  return found.lower >= claimed.lower - gap && found.upper <= claimed.upper + gap;
}

/// The search for bounds of the ratio h(u) / g(u), restricted to the span of the wrenches.
class WrenchBoundSearch {
 public:
  WrenchBoundSearch(const WrenchSet& wrenches, const Gauge& g, const Bounds& claimed)
      : wrenches_(wrenches), g_(g), claimed_(claimed) {
    for (int axis = 0; axis < 6; ++axis) {
      starts_.push_back(Vector6::Unit(axis));
      starts_.push_back(-Vector6::Unit(axis));
    }
    while (std::ssize(starts_) < kStartCount) starts_.push_back(draw_direction());
    for (int k = 0; k < kInitialPointCount; ++k)
      points_.push_back(support(wrenches_, starts_[k]).wrench);
    find_basis();
  }

  const Eigen::MatrixXd& null_directions() const { return null_directions_; }
  const Vector6& worst() const { return worst_; }

  double ratio(const Vector6& u) const {
    const double gauge = g_(u);
    return gauge > kZeroTolerance * u.norm() ? support(wrenches_, u).value / gauge : kInfinity;
  }

  /// Returns the least ratio found by descents from the best of these and of the fixed starts.
  double descend(std::vector<Vector6> starts) {
    for (const Vector6& start : starts_) starts.push_back(project_to_span(start));
    std::ranges::sort(starts, {}, [&](const Vector6& u) { return ratio(u); });
    if (std::ssize(starts) > kDescentCount) starts.resize(kDescentCount);
    double least = kInfinity;
    for (const Vector6& start : starts) least = std::min(least, descend_from(start));
    return least;
  }

  /// Narrows bounds by growing a convex hull in the directions in which the ratio may be least.
  Bounds grow_hull(double upper) {
    Bounds found{-kInfinity, upper};
    for (int round = 0; found.upper > 0 && round < kMaxHullRounds; ++round) {
      if (std::ssize(points_) >= kMaxHullPoints) break;
      std::vector<std::pair<double, Vector6>> ranked;
      for (const HullFacet& facet : facets_of_points()) {
        const Vector6 u = basis_ * facet.normal;
        const double gauge = g_(u);
        const double distance = std::abs(facet.distance) < kZeroTolerance ? 0 : facet.distance;
        if (distance < 0) {  // 0 is not inside the hull yet, so that there is no lower bound
          ranked.emplace_back(-kInfinity, u);
        } else if (gauge > kZeroTolerance) {
          ranked.emplace_back(distance / gauge, u);
        }
      }
      if (ranked.empty()) break;
      std::ranges::stable_sort(ranked, {}, &std::pair<double, Vector6>::first);
      found.lower = std::max(found.lower, ranked.front().first);
      for (const auto& [value, u] : ranked) found.upper = std::min(found.upper, ratio(u));
      if (is_tight(found) || confirms_claim(found, claimed_) || !add_points(ranked, found.upper))
        break;
      worst_ = ranked.front().second;
    }
    return found;
  }

 private:
  Vector6 draw_direction() {
    std::normal_distribution<double> normal;
    Vector6 u;
    for (double& x : u) x = normal(random_);
    return u.normalized();
  }
  Vector6 project_to_span(const Vector6& u) const {
    const Vector6 v = basis_ * (basis_.transpose() * u);
    return v.norm() > 0 ? Vector6(v.normalized()) : Vector6(basis_.col(0));
  }

  /// Finds the basis of the span of the wrenches. If each force is limited, 0 is one of the
  /// wrenches. If the forces sum to 1, it need not be, and the differences of wrenches are spanned.
  void find_basis() {
    if (wrenches_.limits_each_force) points_.push_back(Vector6::Zero());
    Vector6 origin = Vector6::Zero();
    if (!wrenches_.limits_each_force)
      for (const Vector6& point : points_) origin += point / static_cast<double>(points_.size());
    Eigen::MatrixXd columns(6, points_.size());
    for (int k = 0; k < std::ssize(points_); ++k) columns.col(k) = points_[k] - origin;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(columns, Eigen::ComputeFullU);
    const auto& singular = svd.singularValues();
    Eigen::Index rank = 0;
    while (rank < 6 && singular[rank] > kZeroTolerance * singular[0]) ++rank;
    basis_ = svd.matrixU().leftCols(rank);
    null_directions_ = svd.matrixU().rightCols(6 - rank);
  }

  std::vector<HullFacet> facets_of_points() const {
    if (basis_.cols() < 2) return {};
    Eigen::MatrixXd columns(basis_.cols(), points_.size());
    for (int k = 0; k < std::ssize(points_); ++k) columns.col(k) = basis_.transpose() * points_[k];
    return hull_facets(std::move(columns));
  }

  /// Adds the support points in the first ranked directions (with lower bounds of the ratio) that
  /// are well separated from each other. Returns false if there is no new point.
  bool add_points(const std::vector<std::pair<double, Vector6>>& ranked, double upper) {
    std::vector<Vector6> directions;
    const std::size_t old_count = points_.size();
    for (const auto& [value, direction] : ranked) {
      const Vector6& u = direction;  // clang 14 cannot capture structured bindings in lambdas
      if (!(value < upper - tolerated_gap(upper)) || std::ssize(directions) >= kMaxPointsPerRound)
        break;
      const auto is_close = [&](const Vector6& v) { return v.dot(u) > kMaxDirectionCosine; };
      if (std::ranges::any_of(directions, is_close)) continue;
      directions.push_back(u);
      const Vector6 point = support(wrenches_, u).wrench;
      const bool known = std::ranges::any_of(
          points_, [&](const Vector6& other) { return (other - point).norm() < kZeroTolerance; });
      if (!known) points_.push_back(point);
    }
    return points_.size() > old_count;
  }

  double descend_from(Vector6 u) {
    double value = ratio(u);
    for (double step = 0.3; step > 1e-6; step *= 0.5) {
      for (int failed = 0; failed < 30;) {
        const Vector6 next = project_to_span(u + step * draw_direction());
        const double next_value = ratio(next);
        failed = next_value < value ? 0 : failed + 1;
        if (next_value < value) {
          value = next_value;
          u = next;
        }
      }
    }
    return value;
  }

  const WrenchSet& wrenches_;
  const Gauge& g_;
  const Bounds claimed_;
  std::mt19937_64 random_{1};
  std::vector<Vector6> starts_, points_;
  Eigen::MatrixXd basis_, null_directions_;  ///< of the span and of what is orthogonal to it
  Vector6 worst_ = Vector6::Unit(0);         ///< direction with the least lower bound of the ratio
};

/// Bounds epsilon from below by minus the length of the shortest wrench of forces that sum to 1
/// (Gilbert 1966), and from above by h(u) in the opposite direction of that wrench.
Bounds min_norm_bounds(const WrenchSet& wrenches) {
  Vector6 x = support(wrenches, Vector6::Unit(0)).wrench;
  Bounds found;
  for (int step = 0; step < kMaxGilbertSteps; ++step) {
    const double length = x.norm();
    found.lower = std::max(found.lower, -length);
    if (length < kZeroTolerance) break;
    const Support opposite = support(wrenches, -x / length);
    found.upper = std::min(found.upper, opposite.value);
    if (is_tight(found)) break;
    const Vector6 difference = opposite.wrench - x;
    x += std::clamp(-x.dot(difference) / difference.squaredNorm(), 0.0, 1.0) * difference;
  }
  return found;
}

}  // namespace

Bounds epsilon_bounds(const WrenchSet& wrenches, const Bounds& claimed) {
  const Gauge length = [](const Vector6& u) { return u.norm(); };
  WrenchBoundSearch search(wrenches, length, claimed);
  Bounds found;
  if (search.null_directions().cols() > 0) {
    found = min_norm_bounds(wrenches);
    for (const Vector6 u : search.null_directions().colwise())
      found.upper = std::min({found.upper, search.ratio(u), search.ratio(-u)});
    return found;
  }
  found = search.grow_hull(search.descend({}));
  found.upper = std::min(found.upper, search.descend({search.worst()}));
  if (is_tight(found) || confirms_claim(found, claimed)) return found;
  const Bounds shortest = min_norm_bounds(wrenches);
  return {std::max(found.lower, shortest.lower), std::min(found.upper, shortest.upper)};
}

Bounds least_ratio_bounds(const WrenchSet& wrenches, const Gauge& g, const Bounds& claimed) {
  WrenchBoundSearch search(wrenches, g, claimed);
  for (const Vector6 u : search.null_directions().colwise())
    if (std::max(g(u), g(-u)) > kZeroTolerance) return {0, 0};
  Bounds found = search.grow_hull(search.descend({}));
  found.upper = std::max(0.0, std::min(found.upper, search.descend({search.worst()})));
  found.lower = std::max(0.0, found.lower);
  return found;
}

}  // namespace morphe::verify
