#pragma once

#include "core/closure/bounds.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {

/// Signed epsilon of Ferrari and Canny (1992): min over |u| = 1 of h(u), certified from both sides.
///
/// Above 0 it is the radius of the largest ball around 0 inside the set: the weakest wrench that
/// breaks the grasp, per newton of the limit. Of L1 below 0 it is minus the distance of 0 from the
/// hull: the closure residual, the least |wrench| that the contacts leave with normal forces that
/// sum to 1. L∞ holds 0, so its epsilon is never below 0.
struct FerrariCanny {
  double lower = 0, upper = 0;
  Wrench weakest = Wrench::Zero();  ///< unit; h(weakest) = upper
  /// 0 is in the set and the set is flat, or, of L∞, 0 is on its border: h(null) <= 0 to rounding,
  /// so that nothing resists it. Then lower = upper = 0, null = weakest.
  bool exactly_zero = false;
  bool within_tolerance = false;  ///< false: insertions or rounding ended the search
  int insertions = 0;             ///< of support points into the polytope
  int facets = 0;                 ///< of it, in the end

  bool closed() const { return lower > 0; }
  /// The negative part of the lower bound: no more than this is left over.
  double residual() const { return lower < 0 ? -lower : 0; }
};

FerrariCanny ferrari_canny(const ContactSet& contacts, ForceLimit limit,
                           const Tolerance& tolerance = {});

}  // namespace morphe::closure
