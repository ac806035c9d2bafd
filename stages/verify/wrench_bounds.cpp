#include "stages/verify/wrench_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "stages/verify/hull_facets.hpp"

namespace morphe::verify {
namespace {

constexpr double kRelative = 0.05, kAbsolute = 1e-3;  ///< where bounds are near enough
constexpr double kNone = 1e-9;                        ///< rounding makes as much
constexpr std::size_t kFirst = 24, kStarts = 64, kKept = 6, kBatch = 8;
constexpr double kApart = 0.95;
constexpr int kRounds = 60, kMostPoints = 400;
constexpr int kSteps = 20000;

bool near_enough(const Between& b) {
  return std::isfinite(b.lower) &&
         b.upper - b.lower <= std::max(kAbsolute, kRelative * std::abs(b.lower));
}

/// Whether bounds agree with others that are said, as nearly as bounds are wanted.
bool settles(const Between& found, const Between& said) {
  if (!std::isfinite(said.lower) || !std::isfinite(said.upper)) return false;
  const double slack = std::max(kAbsolute, kRelative * std::abs(said.lower));
  return found.lower >= said.lower - slack && found.upper <= said.upper + slack;
}

/// Points and ways in the dimensions that a set of wrenches has: the columns of `base` span them.
class Search {
 public:
  Search(const Pressing& pressing, const Doing& g, const Between& said)
      : pressing_(pressing), g_(g), said_(said) {
    for (int axis = 0; axis < 6; ++axis) {
      starts_.push_back(Vector6::Unit(axis));
      starts_.push_back(-Vector6::Unit(axis));
    }
    while (starts_.size() < kStarts) starts_.push_back(draw());
    for (std::size_t k = 0; k < kFirst; ++k)
      points_.push_back(farthest(pressing_, starts_[k]).wrench);
    find_base();
  }

  const Eigen::MatrixXd& flat() const { return flat_; }

  double ratio(const Vector6& u) {
    const double done = g_(u);
    return done > kNone * u.norm() ? farthest(pressing_, u).most / done : kInfinity;
  }

  /// The least ratio that is found from the best of the starts, and from more given ones.
  double descend(std::vector<Vector6> from) {
    for (const Vector6& start : starts_) from.push_back(within(start));
    std::ranges::sort(from, {}, [&](const Vector6& u) { return ratio(u); });
    if (from.size() > kKept) from.resize(kKept);
    double least = kInfinity;
    for (const Vector6& start : from) least = std::min(least, descend_from(start));
    return least;
  }

  /// A hull grows from the points where it may be least.
  Between grow(double upper) {
    Between found{-kInfinity, upper};
    for (int round = 0; found.upper > 0 && round < kRounds && points_.size() < kMostPoints;
         ++round) {
      std::vector<HullFacet> facets = facets_of_points();
      if (facets.empty()) break;
      std::vector<std::pair<double, Vector6>> worst;
      for (const HullFacet& facet : facets) {
        const Vector6 u = base_ * facet.normal;
        const double done = g_(u), distance = std::abs(facet.distance) < kNone ? 0 : facet.distance;
        if (distance < 0) {  // 0 is not yet inside: nothing is known from below
          worst.emplace_back(-kInfinity, u);
        } else if (done > kNone) {
          worst.emplace_back(distance / done, u);
        }
      }
      if (worst.empty()) break;
      std::ranges::stable_sort(worst, {}, &std::pair<double, Vector6>::first);
      found.lower = std::max(found.lower, worst.front().first);
      for (const auto& [value, u] : worst) found.upper = std::min(found.upper, ratio(u));
      if (near_enough(found) || settles(found, said_) || !add_points(worst, found.upper)) break;
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
  Vector6 within(const Vector6& u) const {
    const Vector6 v = base_ * (base_.transpose() * u);
    return v.norm() > 0 ? Vector6(v.normalized()) : Vector6(base_.col(0));
  }

  /// Of forces that are each limited 0 is one of the wrenches; of those that sum to 1 it need not.
  void find_base() {
    if (pressing_.each) points_.push_back(Vector6::Zero());
    Vector6 middle = Vector6::Zero();
    if (!pressing_.each) {
      for (const Vector6& p : points_) middle += p / static_cast<double>(points_.size());
    }
    Eigen::MatrixXd rows(6, static_cast<Eigen::Index>(points_.size()));
    for (std::size_t k = 0; k < points_.size(); ++k)
      rows.col(static_cast<Eigen::Index>(k)) = points_[k] - middle;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows, Eigen::ComputeFullU);
    Eigen::Index rank = 0;
    while (rank < 6 && svd.singularValues()[rank] > kNone * svd.singularValues()[0]) ++rank;
    base_ = svd.matrixU().leftCols(rank);
    flat_ = svd.matrixU().rightCols(6 - rank);
  }

  std::vector<HullFacet> facets_of_points() const {
    if (base_.cols() < 2) return {};
    Eigen::MatrixXd columns(base_.cols(), static_cast<Eigen::Index>(points_.size()));
    for (std::size_t k = 0; k < points_.size(); ++k)
      columns.col(static_cast<Eigen::Index>(k)) = base_.transpose() * points_[k];
    return hull_facets(std::move(columns));
  }

  /// From ways apart from each other, the worst first.
  bool add_points(const std::vector<std::pair<double, Vector6>>& worst, double upper) {
    const double wanted = upper - std::max(kAbsolute, kRelative * std::abs(upper));
    std::vector<Vector6> asked;
    const std::size_t before = points_.size();
    for (const auto& [value, way] : worst) {
      const Vector6& u = way;  // clang 14 has no bindings in lambdas
      if (!(value < wanted) || asked.size() >= kBatch) break;
      if (std::ranges::any_of(asked, [&](const Vector6& v) { return v.dot(u) > kApart; })) continue;
      asked.push_back(u);
      const Vector6 point = farthest(pressing_, u).wrench;
      const bool known = std::ranges::any_of(
          points_, [&](const Vector6& other) { return (other - point).norm() < kNone; });
      if (!known) points_.push_back(point);
    }
    return points_.size() > before;
  }

  double descend_from(Vector6 u) {
    double value = ratio(u);
    for (double step = 0.3; step > 1e-6; step *= 0.5) {
      for (int failed = 0; failed < 30;) {
        const Vector6 next = within(u + step * draw());
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

  const Pressing& pressing_;
  const Doing& g_;
  const Between said_;
  std::mt19937_64 random_{1};
  std::vector<Vector6> starts_, points_;
  Eigen::MatrixXd base_, flat_;
  Vector6 best_ = Vector6::Unit(0);
};

/// Of the wrenches of forces that sum to 1 the shortest that is found (Gilbert 1966), as a lower
/// bound of epsilon, and h(u) against it as an upper one.
Between by_shortest(const Pressing& pressing) {
  Vector6 x = farthest(pressing, Vector6::Unit(0)).wrench;
  Between found;
  for (int step = 0; step < kSteps; ++step) {
    const double length = x.norm();
    found.lower = std::max(found.lower, -length);
    if (length < kNone) break;
    const Farthest other = farthest(pressing, -x / length);
    found.upper = std::min(found.upper, other.most);
    if (near_enough(found)) break;
    const Vector6 way = other.wrench - x;
    x += std::clamp(-x.dot(way) / way.squaredNorm(), 0.0, 1.0) * way;
  }
  return found;
}

}  // namespace

Between epsilon_between(const Pressing& pressing, const Between& said) {
  const Doing length = [](const Vector6& u) { return u.norm(); };
  Search search(pressing, length, said);
  Between found;
  if (search.flat().cols() > 0) {
    found = by_shortest(pressing);
    for (const Vector6 u : search.flat().colwise()) {
      found.upper = std::min({found.upper, search.ratio(u), search.ratio(-u)});
    }
    return found;
  }
  found = search.grow(search.descend({}));
  found.upper = std::min(found.upper, search.descend({search.best()}));
  if (near_enough(found) || settles(found, said)) return found;
  const Between shortest = by_shortest(pressing);
  return {std::max(found.lower, shortest.lower), std::min(found.upper, shortest.upper)};
}

Between ratio_between(const Pressing& pressing, const Doing& g, const Between& said) {
  Search search(pressing, g, said);
  for (const Vector6 u : search.flat().colwise()) {
    if (std::max(g(u), g(-u)) > kNone) return {0, 0};
  }
  Between found = search.grow(search.descend({}));
  found.upper = std::max(0.0, std::min(found.upper, search.descend({search.best()})));
  found.lower = std::max(0.0, found.lower);
  return found;
}

}  // namespace morphe::verify
