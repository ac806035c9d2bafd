#include "core/closure/incremental_hull.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace morphe::closure {

IncrementalHull::IncrementalHull(const std::vector<Wrench>& corners)
    : dimension_(static_cast<int>(corners.size()) - 1), centre_(Wrench::Zero()), points_(corners) {
  assert(dimension_ >= 1 && dimension_ <= 6);
  for (const Wrench& corner : corners) centre_ += corner / static_cast<double>(corners.size());
  // x = corner 0 + E y: the barycentric coordinate k > 0 is y_k, and decreases fastest against row
  // k of E's pseudo-inverse, which points outwards through the facet without corner k.
  WrenchColumns edges(6, dimension_);
  for (int k = 0; k < dimension_; ++k) {
    edges.col(k) = corners[k + 1] - corners[0];
  }
  const Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 6, 6> inverse =
      edges.colPivHouseholderQr().solve(Eigen::Matrix<double, 6, 6>::Identity());
  const auto n = static_cast<std::size_t>(dimension_);
  for (std::size_t without = 0; without <= n; ++without) {
    Facet facet;
    Wrench inwards;
    if (without == 0) {
      inwards = -inverse.colwise().sum().transpose();
    } else {
      inwards = inverse.row(without - 1).transpose();
    }
    facet.normal = -inwards.normalized();
    for (std::size_t slot = 0; slot < n; ++slot) {
      // Corners are in order; facet j lacks corner j, so the facet opposite a corner is its
      // neighbour.
      const std::size_t corner = slot < without ? slot : slot + 1;
      facet.vertex[slot] = static_cast<std::int32_t>(corner);
      facet.neighbour[slot] = static_cast<std::int32_t>(corner);
      facet.reciprocal_slot[slot] =
          static_cast<std::int8_t>(without < corner ? without : without - 1);
    }
    proper_ = set_distance(facet) && proper_;
    facets_.push_back(facet);
  }
}

/// Sets the distance; returns false if the centre is not behind the facet.
bool IncrementalHull::set_distance(Facet& facet) const {
  facet.distance = kInfinity;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
    const auto vertex = static_cast<std::size_t>(facet.vertex[k]);
    facet.distance = std::min(facet.distance, facet.normal.dot(points_[vertex]));
  }
  return facet.normal.dot(centre_) < facet.distance;
}

bool IncrementalHull::insert(const Wrench& point, std::int32_t beyond, double slack) {
  const std::int32_t stamp = ++insertions_;
  const auto look = [&](std::int32_t id) {
    Facet& facet = facets_[id];
    if (facet.visited_by != stamp) {
      facet.visited_by = stamp;
      facet.height = facet.normal.dot(point) - facet.distance;
      if (facet.height > slack) visible_.push_back(id);
    }
    return facet.height > slack;
  };
  visible_.clear();
  horizon_.clear();
  if (!look(beyond)) return false;
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    const std::int32_t id = visible_[k];
    for (std::size_t slot = 0; slot < static_cast<std::size_t>(dimension_); ++slot) {
      const std::int32_t across = facets_[id].neighbour[slot];
      if (!look(across)) horizon_.push_back({id, static_cast<std::int32_t>(slot)});
    }
  }
  const std::size_t first = facets_.size();
  points_.push_back(point);
  for (const Ridge& ridge : horizon_) {
    if (!make_facet(ridge.visible, ridge.slot)) {
      facets_.resize(first);
      points_.pop_back();
      return false;
    }
  }
  join_new_facets(first);
  for (const std::int32_t id : visible_) facets_[id].alive = false;
  return true;
}

/// Makes the facet of the last point and the ridge of a visible facet without its vertex `slot`.
bool IncrementalHull::make_facet(std::int32_t visible, std::size_t slot) {
  const Facet& near = facets_[visible];
  const Facet& far = facets_[near.neighbour[slot]];
  Facet made;
  made.vertex = near.vertex;
  made.vertex[slot] = static_cast<std::int32_t>(points_.size()) - 1;
  made.neighbour[slot] = near.neighbour[slot];
  made.reciprocal_slot[slot] = near.reciprocal_slot[slot];
  // Every plane through the ridge is a combination of the planes of both facets. For the plane
  // through the point the weights are not negative, which keeps rounding from growing.
  made.normal = (near.height * far.normal + std::max(0.0, -far.height) * near.normal).normalized();
  const bool behind = set_distance(made);
  facets_.push_back(made);
  return behind;
}

/// Connects the new facets: around a ridge without one more vertex, it passes the visible facets
/// one after the other until it reaches the horizon again.
void IncrementalHull::join_new_facets(std::size_t first) {
  for (std::size_t k = 0; k < horizon_.size(); ++k) {
    const auto id = static_cast<std::int32_t>(first + k);
    const auto slot = static_cast<std::size_t>(horizon_[k].slot);
    Facet& visible = facets_[horizon_[k].visible];
    const Facet& made = facets_[first + k];
    Facet& far = facets_[made.neighbour[slot]];
    far.neighbour[made.reciprocal_slot[slot]] = id;
    far.reciprocal_slot[made.reciprocal_slot[slot]] = static_cast<std::int8_t>(slot);
    visible.neighbour[slot] = id;
    visible.reciprocal_slot[slot] = static_cast<std::int8_t>(slot);
  }
  for (std::size_t k = 0; k < horizon_.size(); ++k) {
    Facet& made = facets_[first + k];
    const auto ridge = static_cast<std::size_t>(horizon_[k].slot);
    for (std::size_t slot = 0; slot < static_cast<std::size_t>(dimension_); ++slot) {
      if (slot == ridge) continue;
      const Facet* here = &facets_[horizon_[k].visible];
      std::size_t across = slot, kept = ridge;
      while (static_cast<std::size_t>(here->neighbour[across]) < first) {
        const Facet* next = &facets_[here->neighbour[across]];
        const auto entry = static_cast<std::size_t>(here->reciprocal_slot[across]);
        const auto turn = std::find(next->vertex.begin(), next->vertex.end(), here->vertex[kept]);
        across = turn - next->vertex.begin();
        kept = entry;
        here = next;
      }
      made.neighbour[slot] = here->neighbour[across];
      made.reciprocal_slot[slot] = static_cast<std::int8_t>(kept);
    }
  }
}

}  // namespace morphe::closure
