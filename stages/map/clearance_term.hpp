#pragma once

#include "core/collision/world.hpp"
#include "core/solve/quadratic.hpp"

namespace morphe::map {

/// A term of ours beside the paper's: weight * sum over pairs of max(0, band - slack)², with the
/// slack of the collision check (distance less the margin asked for), so that the mapping stays a
/// little clear of itself and of fixed obstacles. Zero beyond the band; once differentiable. Of a
/// pair that may touch the band is no wider than what it may sink in: it ends at the surface.
struct ClearanceTerm {
  double weight = 2000;  ///< per m²; 0 = off, as in the paper's studies
  double band_m = 0.005;
};
template <class Fields>
void fields(Fields& f, ClearanceTerm& o) {
  f("weight", o.weight);
  f("band", o.band_m);
}
std::string why_invalid(const ClearanceTerm& term);

struct ClearanceScratch {
  collision::CollisionScratch collision;
  std::vector<collision::PairSeparation> pairs;
  JointVector slope;                ///< [n] of the slack missing from the band
  std::vector<Eigen::Index> parts;  ///< joints that part the two bodies of a pair: few
};

void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world,
                   const JointVector& q, double time_s, ClearanceScratch& scratch,
                   solve::Quadratic& model);
/// The same where `scratch.collision.base_from_frame` is that of q already.
void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world, double time_s,
                   ClearanceScratch& scratch, solve::Quadratic& model);

}  // namespace morphe::map
