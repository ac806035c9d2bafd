#include "core/closure/incremental_hull.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>

namespace morphe::closure {

IncrementalHull::IncrementalHull(const std::vector<Wrench>& corners)
    : dimension_(static_cast<int>(corners.size()) - 1), centre_(Wrench::Zero()), points_(corners) {
  assert(dimension_ >= 1 && dimension_ <= 6);
  for (const Wrench& corner : corners) centre_ += corner / static_cast<double>(corners.size());
  // With x = corner 0 + E y, the barycentric coordinate k > 0 is y_k. Its gradient, row k of E's
  // pseudo-inverse, points inwards through the facet without corner k.
  WrenchColumns edges(6, dimension_);
  for (int k = 0; k < dimension_; ++k) edges.col(k) = corners[k + 1] - corners[0];
  const Eigen::Matrix<double, Eigen::Dynamic, 6, 0, 6, 6> inverse =
      edges.colPivHouseholderQr().solve(Eigen::Matrix<double, 6, 6>::Identity());
  for (int without = 0; without <= dimension_; ++without) {
    Facet facet;
    Wrench inwards;
    if (without == 0)
      inwards = -inverse.colwise().sum().transpose();
    else
      inwards = inverse.row(without - 1).transpose();
    facet.normal = -inwards.normalized();
    for (int slot = 0; slot < dimension_; ++slot) {
      // Facet j lacks corner j, so the neighbour opposite corner j is facet j.
      const int corner = slot < without ? slot : slot + 1;
      facet.vertex[slot] = facet.neighbour[slot] = corner;
      facet.reciprocal_slot[slot] = without < corner ? without : without - 1;
    }
    proper_ = set_distance(facet) && proper_;
    facets_.push_back(facet);
  }
}

/// Sets the distance; returns false if the centre is not behind the facet.
bool IncrementalHull::set_distance(Facet& facet) const {
  facet.distance = kInfinity;
  for (int k = 0; k < dimension_; ++k)
    facet.distance = std::min(facet.distance, facet.normal.dot(points_[facet.vertex[k]]));
  return facet.normal.dot(centre_) < facet.distance;
}

bool IncrementalHull::insert(const Wrench& point, int beyond, double slack) {
  const int stamp = ++insertions_;
  const auto visit = [&](int id) {
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
  if (!visit(beyond)) return false;
  for (int k = 0; k < std::ssize(visible_); ++k) {
    const int id = visible_[k];
    for (int slot = 0; slot < dimension_; ++slot) {
      const int across = facets_[id].neighbour[slot];
      if (!visit(across)) horizon_.push_back({id, slot});
    }
  }
  const int first = static_cast<int>(facets_.size());
  points_.push_back(point);
  for (const Ridge& ridge : horizon_) {
    if (!make_facet(ridge.visible, ridge.slot)) {
      facets_.resize(first);
      points_.pop_back();
      return false;
    }
  }
  join_new_facets(first);
  for (const int id : visible_) facets_[id].alive = false;
  return true;
}

/// Makes the facet of the last point and the ridge of a visible facet without its vertex `slot`.
bool IncrementalHull::make_facet(int visible, int slot) {
  const Facet& seen = facets_[visible];
  const Facet& far = facets_[seen.neighbour[slot]];
  Facet made;
  made.vertex = seen.vertex;
  made.vertex[slot] = static_cast<int>(points_.size()) - 1;
  made.neighbour[slot] = seen.neighbour[slot];
  made.reciprocal_slot[slot] = seen.reciprocal_slot[slot];
  // Every plane through the ridge is a combination of the planes of both facets. For the plane
  // through the point the weights are not negative, which keeps rounding from growing.
  made.normal = (seen.height * far.normal + std::max(0.0, -far.height) * seen.normal).normalized();
  const bool behind = set_distance(made);
  facets_.push_back(made);
  return behind;
}

/// Connects the new facets: the neighbour of one across the ridge without vertex `slot` is found by
/// passing the visible facets around the rest of its horizon ridge, up to the horizon.
void IncrementalHull::join_new_facets(int first) {
  for (int k = 0; k < std::ssize(horizon_); ++k) {
    const int slot = horizon_[k].slot;
    Facet& visible = facets_[horizon_[k].visible];
    const Facet& made = facets_[first + k];
    Facet& far = facets_[made.neighbour[slot]];
    far.neighbour[made.reciprocal_slot[slot]] = visible.neighbour[slot] = first + k;
    far.reciprocal_slot[made.reciprocal_slot[slot]] = visible.reciprocal_slot[slot] = slot;
  }
  for (int k = 0; k < std::ssize(horizon_); ++k) {
    Facet& made = facets_[first + k];
    const int ridge = horizon_[k].slot;
    for (int slot = 0; slot < dimension_; ++slot) {
      if (slot == ridge) continue;
      const Facet* here = &facets_[horizon_[k].visible];
      int across = slot, kept = ridge;
      while (here->neighbour[across] < first) {
        const Facet* next = &facets_[here->neighbour[across]];
        const int entry = here->reciprocal_slot[across];
        across = 0;
        while (next->vertex[across] != here->vertex[kept]) ++across;
        kept = entry;
        here = next;
      }
      made.neighbour[slot] = here->neighbour[across];
      made.reciprocal_slot[slot] = kept;
    }
  }
}

}  // namespace morphe::closure
