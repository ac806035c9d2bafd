#include "stages/verify/wrench_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "stages/verify/hull_facets.hpp"

namespace morphe::verify {
namespace {

/// gap at which bounds are close enough
constexpr double kBoundGapRatio = 0.05, kMinBoundGap = 1e-3;
constexpr double kZeroTolerance = 1e-9;  ///< magnitude of rounding errors
constexpr std::size_t kInitialPointCount = 24, kStartCount = 64, kDescentCount = 6,
                      kMaxPointsPerRound = 8;
constexpr double kMaxDirectionCosine = 0.95;
constexpr int kMaxHullRounds = 60, kMaxHullPoints = 400;
constexpr int kMaxGilbertSteps = 20000;

bool is_tight(const Bounds& b) {
  return std::isfinite(b.lower) &&
         b.upper - b.lower <= std::max(kMinBoundGap, kBoundGapRatio * std::abs(b.lower));
}

/// Returns true if the bounds found agree with the claimed ones to the requested accuracy.
bool confirms_claim(const Bounds& found, const Bounds& said) {
  if (!std::isfinite(said.lower) || !std::isfinite(said.upper)) return false;
  const double slack = std::max(kMinBoundGap, kBoundGapRatio * std::abs(said.lower));
  return found.lower >= said.lower - slack && found.upper <= said.upper + slack;
}

/// The search for bounds, restricted to the subspace spanned by the set of wrenches, whose basis is
/// the columns of `base`.
class WrenchBoundSearch {
 public:
  WrenchBoundSearch(const WrenchSet& pressing, const Gauge& g, const Bounds& said)
      : pressing_(pressing), g_(g), claimed_(said) {
    for (int axis = 0; axis < 6; ++axis) {
      starts_.push_back(Vector6::Unit(axis));
      starts_.push_back(-Vector6::Unit(axis));
    }
    while (starts_.size() < kStartCount) starts_.push_back(draw());
    for (std::size_t k = 0; k < kInitialPointCount; ++k)
      points_.push_back(support(pressing_, starts_[k]).wrench);
    find_base();
  }

  const Eigen::MatrixXd& null_directions() const { return flat_; }

  double ratio(const Vector6& u) {
    const double done = g_(u);
    return done > kZeroTolerance * u.norm() ? support(pressing_, u).value / done : kInfinity;
  }

  /// Returns the least ratio found by descents from the best of the starts and of the additional
  /// points `from`.
  double descend(std::vector<Vector6> from) {
    for (const Vector6& start : starts_) from.push_back(project_to_span(start));
    std::ranges::sort(from, {}, [&](const Vector6& u) { return ratio(u); });
    if (from.size() > kDescentCount) from.resize(kDescentCount);
    double least = kInfinity;
    for (const Vector6& start : from) least = std::min(least, descend_from(start));
    return least;
  }

  /// Computes bounds by growing a convex hull towards the points at which the ratio may be least.
  Bounds grow(double upper) {
    Bounds found{-kInfinity, upper};
    for (int round = 0;
         found.upper > 0 && round < kMaxHullRounds && points_.size() < kMaxHullPoints; ++round) {
      std::vector<HullFacet> facets = facets_of_points();
      if (facets.empty()) break;
      std::vector<std::pair<double, Vector6>> worst;
      for (const HullFacet& facet : facets) {
        const Vector6 u = base_ * facet.normal;
        const double done = g_(u),
                     distance = std::abs(facet.distance) < kZeroTolerance ? 0 : facet.distance;
        if (distance < 0) {  // 0 is not inside the hull yet, so that there is no lower bound
          worst.emplace_back(-kInfinity, u);
        } else if (done > kZeroTolerance) {
          worst.emplace_back(distance / done, u);
        }
      }
      if (worst.empty()) break;
      std::ranges::stable_sort(worst, {}, &std::pair<double, Vector6>::first);
      found.lower = std::max(found.lower, worst.front().first);
      for (const auto& [value, u] : worst) found.upper = std::min(found.upper, ratio(u));
      if (is_tight(found) || confirms_claim(found, claimed_) || !add_points(worst, found.upper))
        break;
      best_ = worst.front().second;
    }
    return found;
  }
  const Vector6& best() const { return best_; }

 private:
  Vector6 draw() {
    std::normal_distribution<double> normal;
    Vector6 u;
    for (double& x : u) x = normal(random_);
    return u.normalized();
  }
  Vector6 project_to_span(const Vector6& u) const {
    const Vector6 v = base_ * (base_.transpose() * u);
    return v.norm() > 0 ? Vector6(v.normalized()) : Vector6(base_.col(0));
  }

  /// Finds the basis of the span of the wrenches. For individually bounded forces, 0 is one of the
  /// wrenches; for forces that sum to 1 it need not be.
  void find_base() {
    if (pressing_.individually_bounded) points_.push_back(Vector6::Zero());
    Vector6 middle = Vector6::Zero();
    if (!pressing_.individually_bounded) {
      for (const Vector6& p : points_) middle += p / static_cast<double>(points_.size());
    }
    Eigen::MatrixXd rows(6, points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k) rows.col(k) = points_[k] - middle;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullU);
    Eigen::Index rank = 0;
    while (rank < 6 && svd.singularValues()[rank] > kZeroTolerance * svd.singularValues()[0])
      ++rank;
    base_ = svd.matrixU().leftCols(rank);
    flat_ = svd.matrixU().rightCols(6 - rank);
  }

  std::vector<HullFacet> facets_of_points() const {
    if (base_.cols() < 2) return {};
    Eigen::MatrixXd columns(base_.cols(), points_.size());
    for (std::size_t k = 0; k < points_.size(); ++k)
      columns.col(k) = base_.transpose() * points_[k];
    return hull_facets(std::move(columns));
  }

  /// Adds support points in directions that are well separated from each other, the worst first.
  bool add_points(const std::vector<std::pair<double, Vector6>>& worst, double upper) {
    const double wanted = upper - std::max(kMinBoundGap, kBoundGapRatio * std::abs(upper));
    std::vector<Vector6> asked;
    const std::size_t before = points_.size();
    for (const auto& [value, way] : worst) {
      const Vector6& u = way;  // clang 14 cannot capture structured bindings in lambdas
      if (!(value < wanted) || asked.size() >= kMaxPointsPerRound) break;
      if (std::ranges::any_of(asked,
                              [&](const Vector6& v) { return v.dot(u) > kMaxDirectionCosine; }))
        continue;
      asked.push_back(u);
      const Vector6 point = support(pressing_, u).wrench;
      const bool known = std::ranges::any_of(
          points_, [&](const Vector6& other) { return (other - point).norm() < kZeroTolerance; });
      if (!known) points_.push_back(point);
    }
    return points_.size() > before;
  }

  double descend_from(Vector6 u) {
    double value = ratio(u);
    for (double step = 0.3; step > 1e-6; step *= 0.5) {
      for (int failed = 0; failed < 30;) {
        const Vector6 next = project_to_span(u + step * draw());
        const double there = ratio(next);
        failed = there < value ? 0 : failed + 1;
        if (there < value) {
          value = there;
          u = next;
        }
      }
    }
    return value;
  }

  const WrenchSet& pressing_;
  const Gauge& g_;
  const Bounds claimed_;
  std::mt19937_64 random_{1};
  std::vector<Vector6> starts_, points_;
  Eigen::MatrixXd base_, flat_;
  Vector6 best_ = Vector6::Unit(0);
};

/// Finds the shortest wrench of forces that sum to 1 (Gilbert 1966), as a lower bound of epsilon,
/// and uses h(u) in its direction as an upper bound.
Bounds min_norm_bounds(const WrenchSet& pressing) {
  Vector6 x = support(pressing, Vector6::Unit(0)).wrench;
  Bounds found;
  for (int step = 0; step < kMaxGilbertSteps; ++step) {
    const double length = x.norm();
    found.lower = std::max(found.lower, -length);
    if (length < kZeroTolerance) break;
    const Support other = support(pressing, -x / length);
    found.upper = std::min(found.upper, other.value);
    if (is_tight(found)) break;
    const Vector6 way = other.wrench - x;
    x += std::clamp(-x.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  return found;
}

}  // namespace

Bounds epsilon_bounds(const WrenchSet& pressing, const Bounds& said) {
  const Gauge length = [](const Vector6& u) { return u.norm(); };
  WrenchBoundSearch search(pressing, length, said);
  Bounds found;
  if (search.null_directions().cols() > 0) {
    found = min_norm_bounds(pressing);
    for (const Vector6 u : search.null_directions().colwise()) {
      found.upper = std::min({found.upper, search.ratio(u), search.ratio(-u)});
    }
    return found;
  }
  found = search.grow(search.descend({}));
  found.upper = std::min(found.upper, search.descend({search.best()}));
  if (is_tight(found) || confirms_claim(found, said)) return found;
  const Bounds shortest = min_norm_bounds(pressing);
  return {std::max(found.lower, shortest.lower), std::min(found.upper, shortest.upper)};
}

Bounds least_ratio_bounds(const WrenchSet& pressing, const Gauge& g, const Bounds& said) {
  WrenchBoundSearch search(pressing, g, said);
  for (const Vector6 u : search.null_directions().colwise()) {
    if (std::max(g(u), g(-u)) > kZeroTolerance) return {0, 0};
  }
  Bounds found = search.grow(search.descend({}));
  found.upper = std::max(0.0, std::min(found.upper, search.descend({search.best()})));
  found.lower = std::max(0.0, found.lower);
  return found;
}

}  // namespace morphe::verify
