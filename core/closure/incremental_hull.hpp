#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// The convex hull of n + 1 points in general position in n <= 6 dimensions, to which points are
/// added: a closed surface of facets with n vertices each, in which every ridge of n - 1 vertices
/// belongs to exactly two facets.
///
/// Independently of rounding, the surface is closed, it winds around `centre`, and all of a facet
/// is in normal·x >= distance. So every point that a straight line from the centre reaches without
/// crossing normal·x = distance of any facet is in the hull of the points. Convexity holds only to
/// rounding, and is not required.
class IncrementalHull {
 public:
  /// A facet of the surface.
  struct Facet {
    std::array<std::int32_t, 6> vertex{};     ///< only the first n are used
    std::array<std::int32_t, 6> neighbour{};  ///< across the ridge without vertex [k]
    /// This facet's index among that neighbour's neighbours.
    std::array<std::int8_t, 6> reciprocal_slot{};
    bool alive = true;
    std::int32_t visited_by = 0;  ///< last insertion that visited it
    double height = 0;            ///< height of the inserted point above it
    Wrench normal;                ///< unit, outwards
    double distance = 0;          ///< smallest normal·vertex
  };

  /// Builds the hull of at least two affinely independent points.
  explicit IncrementalHull(const std::vector<Wrench>& corners);

  /// Adds a point beyond a facet: this facet, and all facets connected to it that the point is
  /// beyond by more than `slack`, are replaced by new ones. Returns false, without any change, if
  /// the point is not beyond the facet, or if the centre would not be behind a new facet by more
  /// than rounding.
  bool insert(const Wrench& point, std::int32_t beyond, double slack);

  /// Returns false if the points are so nearly dependent that the centre is not certainly inside;
  /// the guarantees above then do not hold.
  bool is_proper() const { return proper_; }
  /// Returns the facets in the order of their creation, including those that were replaced and are
  /// no longer alive.
  const std::vector<Facet>& facets() const { return facets_; }
  /// Returns a point inside the hull.
  const Wrench& centre() const { return centre_; }
  /// Returns the dimension n.
  int dimension() const { return dimension_; }

 private:
  bool make_facet(std::int32_t visible, std::size_t slot);
  void join_new_facets(std::size_t first);
  bool set_distance(Facet& facet) const;

  int dimension_ = 0;
  bool proper_ = true;
  Wrench centre_;
  std::vector<Wrench> points_;
  std::vector<Facet> facets_;
  std::int32_t insertions_ = 0;  ///< number of attempts
  std::vector<std::int32_t> visible_;
  /// A ridge between a replaced facet and one that remains.
  struct Ridge {
    std::int32_t visible;  ///< the replaced facet
    std::int32_t slot;     ///< index of its vertex that is not on the ridge
  };
  std::vector<Ridge> horizon_;
};

}  // namespace morphe::closure
