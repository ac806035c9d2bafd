#pragma once

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// The signed quality epsilon of Ferrari and Canny (1992), min h(u) over |u| = 1, with certified
/// lower and upper bounds.
///
/// A positive value is the radius of the largest ball around 0 inside the wrench set: the smallest
/// wrench that breaks the grasp, per newton of the force limit. For L1, a negative value is minus
/// the distance of 0 from the hull: the closure residual, the smallest |wrench| that remains for
/// normal forces that sum to 1. For L∞ the set contains 0, so epsilon is never negative.
struct FerrariCanny {
  double lower = 0, upper = 0;
  Wrench weakest_twist = Wrench::Zero();  ///< unit vector; h(weakest_twist) = upper
  /// True if 0 is in the set and the set is flat, or, for L∞, if 0 is on its boundary:
  /// h(weakest_twist) <= 0 to rounding, so this twist is not resisted. Then lower = upper = 0.
  bool exactly_zero = false;
  bool within_tolerance = false;  ///< false if insertions or rounding ended the search
  int insertions = 0;             ///< number of support points inserted into the polytope
  int facets = 0;                 ///< final number of facets of the polytope

  /// Returns true if the grasp certainly has force closure.
  bool force_closure() const { return lower > 0; }
  /// Returns the negative part of the lower bound, an upper bound of the closure residual.
  double residual() const { return lower < 0 ? -lower : 0; }
};

/// Computes epsilon of a grasp; without contacts it is exactly 0.
FerrariCanny ferrari_canny(const ContactSet& contacts, ForceLimit limit,
                           const BoundTolerance& tolerance = {});

}  // namespace morphe::closure
