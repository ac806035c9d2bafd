#pragma once

#include <array>
#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// The convex hull of n + 1 points in general position in n <= 6 dimensions, to which points are
/// added: a closed surface of facets with n vertices each, in which every ridge of n - 1 vertices
/// belongs to exactly two facets. Independently of rounding, the surface is closed, it winds around
/// `centre`, and all of a facet is in normal·x >= distance. So every point that a straight line
/// from the centre reaches without crossing normal·x = distance of any facet is in the hull of the
/// points. Convexity holds only to rounding, and is not required.
class IncrementalHull {
 public:
  /// A facet of the surface.
  struct Facet {
    std::array<int, 6> vertex{};           ///< only the first n are used
    std::array<int, 6> neighbour{};        ///< across the ridge without vertex [k]
    std::array<int, 6> reciprocal_slot{};  ///< this facet's index among that neighbour's
    bool alive = true;
    int visited_by = 0;   ///< last insertion that visited it
    double height = 0;    ///< of that insertion's point above the facet
    Wrench normal;        ///< unit, outwards
    double distance = 0;  ///< smallest normal·vertex
  };

  /// Builds the hull of at least two affinely independent points.
  explicit IncrementalHull(const std::vector<Wrench>& corners);

  /// Adds a point beyond the facet of index `beyond`. Replaces this facet and all connected ones
  /// that the point is beyond by more than `slack`. Returns false, without a change of the surface,
  /// if this facet is not among them, or if the centre would not be behind a new facet.
  bool insert(const Wrench& point, int beyond, double slack);

  /// Returns false if the points are so nearly dependent that the centre is not certainly inside:
  /// nothing above is then guaranteed.
  bool is_proper() const { return proper_; }
  /// Returns the facets in the order of their creation, also those that are no longer alive.
  const std::vector<Facet>& facets() const { return facets_; }
  /// Returns a point inside the hull.
  const Wrench& centre() const { return centre_; }
  /// Returns the dimension n.
  int dimension() const { return dimension_; }

 private:
  bool make_facet(int visible, int slot);
  void join_new_facets(int first);
  bool set_distance(Facet& facet) const;

  int dimension_ = 0;
  bool proper_ = true;
  Wrench centre_;
  std::vector<Wrench> points_;
  std::vector<Facet> facets_;
  int insertions_ = 0;  ///< number of attempts
  std::vector<int> visible_;
  /// A ridge between a replaced facet and one that remains.
  struct Ridge {
    int visible;  ///< the replaced facet
    int slot;     ///< of its vertex that is not on the ridge
  };
  std::vector<Ridge> horizon_;
};

}  // namespace morphe::closure
