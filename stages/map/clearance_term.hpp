#pragma once

#include "core/collision/world.hpp"
#include "core/motion/key_bounds.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::map {

/// A penalty on small clearances from the robot itself and from obstacles, in addition to the
/// paper's terms: weight * sum over pairs of max(0, band - slack)², with the slack of the collision
/// check (distance less the required margin). For a pair that may touch, the band is at most as
/// wide as the allowed penetration is deep, so that it ends at the surface. Once differentiable.
struct ClearanceTerm {
  double weight = 15000;  ///< weight per m²; 0 disables the term, as in the paper's studies
  double activation_distance_m = 0.005;  ///< width of the band
};
template <class Fields>
void fields(Fields& f, ClearanceTerm& o) {
  f("weight", o.weight, bounds::kWeight);
  f("activation_distance", o.activation_distance_m, bounds::kPositiveLength);
}

/// Buffers of add_clearance(), reused from call to call.
struct ClearanceScratch {
  collision::CollisionScratch collision;
  std::vector<collision::PairSeparation> pairs;  ///< pairs within the band
  JointVector missing_gradient;                  ///< [n] gradient of band - slack
  std::vector<Eigen::Index> active_joints;       ///< joints that change the distance of a pair
};

/// Adds the term at q, with the objects where they are at `time_s`, to `model` (already sized n):
/// its value, gradient and Gauss-Newton Hessian.
void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world,
                   const JointVector& q, double time_s, ClearanceScratch& scratch,
                   solve::Quadratic& model);
/// Does the same if `scratch.collision.base_from_frame` already holds the forward kinematics of q.
void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world, double time_s,
                   ClearanceScratch& scratch, solve::Quadratic& model);

}  // namespace morphe::map
