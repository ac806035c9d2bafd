#include "core/math/convex_hull_2d.hpp"

#include <algorithm>

namespace morphe::math {

std::vector<Eigen::Vector2d> convex_hull_2d(std::vector<Eigen::Vector2d> points) {
  using Point = Eigen::Vector2d;
  std::ranges::sort(points, [](const Point& a, const Point& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  const auto turns_left = [](const Point& a, const Point& b, const Point& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x() > 0;
  };
  std::vector<Eigen::Vector2d> hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto point = begin; point != end; ++point) {
      while (hull.size() >= first + 2 &&
             !turns_left(hull[hull.size() - 2], hull[hull.size() - 1], *point))
        hull.pop_back();
      hull.push_back(*point);
    }
    hull.pop_back();
  };
  if (points.size() < 3) return points;
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace morphe::math
