#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// The hull of n + 1 points in general position in n <= 6 dimensions, to which points are added: a
/// closed surface of facets with n vertices each, every ridge of n - 1 vertices in just two of
/// them.
///
/// What is certain whatever rounding does: the surface stays closed, it winds around `centre`, and
/// all of a facet lies in normal·x >= distance. So every point that a straight way from the centre
/// leads to without reaching normal·x = distance of any facet is in the hull of the points. Convex
/// it is to rounding only, and nothing depends on that.
class GrowingPolytope {
 public:
  struct Facet {
    std::array<std::int32_t, 6> vertex{};     ///< the first n count
    std::array<std::int32_t, 6> neighbour{};  ///< across the ridge without vertex [k]
    std::array<std::int8_t, 6> back{};        ///< this facet's place among that neighbour's
    bool alive = true;
    std::int32_t seen_by = 0;  ///< the insertion that looked at it last
    double height = 0;         ///< the inserted point's above it
    Wrench normal;             ///< unit, outwards
    double distance = 0;       ///< least normal·vertex
  };

  /// The points are affinely independent, at least two.
  explicit GrowingPolytope(const std::vector<Wrench>& corners);

  /// Adds a point beyond a facet: all facets that it lies beyond by more than `slack`, and that
  /// hang together with this one, make way for new ones. False, and nothing has changed, where it
  /// lies beyond none, or where a new facet would not have the centre behind it by more than
  /// rounding.
  bool insert(const Wrench& point, std::int32_t beyond, double slack);

  /// False where the points are so nearly dependent that the centre is not surely inside: then
  /// nothing is certain.
  bool proper() const { return proper_; }
  /// In the order in which they were made; those that had to go stay, no longer alive.
  const std::vector<Facet>& facets() const { return facets_; }
  const Wrench& centre() const { return centre_; }
  int dimension() const { return dimension_; }

 private:
  bool make_facet(std::int32_t visible, std::size_t slot);
  void join_new_facets(std::size_t first);
  bool measure(Facet& facet) const;

  int dimension_ = 0;
  bool proper_ = true;
  Wrench centre_;
  std::vector<Wrench> points_;
  std::vector<Facet> facets_;
  std::int32_t insertions_ = 0;  ///< tried
  std::vector<std::int32_t> visible_;
  struct Ridge {
    std::int32_t visible;  ///< the facet that goes
    std::int32_t slot;     ///< its vertex that the ridge lacks
  };
  std::vector<Ridge> horizon_;
};

}  // namespace morphe::closure
