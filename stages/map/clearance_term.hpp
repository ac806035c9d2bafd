#pragma once

#include "core/collision/world.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::map {

/// A penalty on small clearances, in addition to the paper's terms: weight * sum over pairs of
/// max(0, band - slack)², with the slack of the collision check (distance less the required
/// margin), so that the mapping keeps some clearance from the robot itself and from fixed
/// obstacles. It is zero beyond the band and once differentiable. For a pair that may touch, the
/// band is no wider than its allowed penetration depth, so that it ends at the surface.
struct ClearanceTerm {
  double weight = 2000;  ///< weight per m²; 0 disables the term, as in the paper's studies
  /// The band: slack below which the term is active [m].
  double activation_distance_m = 0.005;
};
template <class Fields>
void fields(Fields& f, ClearanceTerm& o) {
  f("weight", o.weight);
  f("activation_distance", o.activation_distance_m);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const ClearanceTerm& term);

/// Buffers of add_clearance(), reused from call to call.
struct ClearanceScratch {
  collision::CollisionScratch collision;
  std::vector<collision::PairSeparation> pairs;  ///< pairs within the band
  /// [n] gradient of the amount by which the slack is missing from the band.
  JointVector slack_gradient;
  /// The few joints that change the distance of the two bodies of a pair.
  std::vector<Eigen::Index> active_joints;
};

/// Adds the value, gradient and Gauss-Newton Hessian of the term at q to `model`.
void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world,
                   const JointVector& q, double time_s, ClearanceScratch& scratch,
                   solve::Quadratic& model);
/// Does the same if `scratch.collision.base_from_frame` already holds the forward kinematics of q.
void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world, double time_s,
                   ClearanceScratch& scratch, solve::Quadratic& model);

}  // namespace morphe::map
