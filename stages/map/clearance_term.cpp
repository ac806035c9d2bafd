#include "stages/map/clearance_term.hpp"

#include "pipeline/kinematics/forward.hpp"

namespace morphe {

std::string check(const ClearanceTerm& term) {
  if (term.weight < 0) return "weight must not be negative";
  if (term.band_m <= 0) return "band must be positive";
  return "";
}

void add_clearance(const ClearanceTerm& term, const CollisionWorld& world, const JointVector& q,
                   double time_s, ClearanceScratch& scratch, Quadratic& model) {
  if (term.weight == 0) return;
  near_pairs(world, q, time_s, term.band_m, scratch.collision, scratch.pairs);
  const auto count = static_cast<Eigen::Index>(scratch.pairs.size());
  if (count == 0) return;
  scratch.missing.resize(count);
  scratch.rows.resize(count, q.size());
  scratch.jacobian.resize(3, q.size());
  const auto add_slack = [&](int capsule, const Vec3& point, const Vec3& along, Eigen::Index row) {
    const int frame = world.robot->capsules[static_cast<std::size_t>(capsule)].frame;
    point_jacobian(*world.robot, scratch.collision.base_from_frame, frame, point, scratch.jacobian);
    scratch.rows.row(row).noalias() += along.transpose() * scratch.jacobian;
  };
  scratch.rows.setZero();
  for (Eigen::Index k = 0; k < count; ++k) {
    const PairSeparation& pair = scratch.pairs[static_cast<std::size_t>(k)];
    const Separation& s = pair.separation;
    add_slack(pair.capsule, s.on_first, -s.normal, k);
    if (!pair.object) add_slack(pair.other, s.on_second, s.normal, k);
    scratch.missing[k] = term.band_m - pair.slack();
  }
  model.add_squares(term.weight, scratch.missing, scratch.rows);
}

}  // namespace morphe
