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
  Eigen::Matrix3Xd jacobian(3, q.size());
  const auto slack_row = [&](int capsule, const Vec3& point, const Vec3& normal) {
    const int frame = world.robot->capsules[static_cast<std::size_t>(capsule)].frame;
    point_jacobian(*world.robot, scratch.collision.base_from_frame, frame, point, jacobian);
    return Eigen::RowVectorXd(normal.transpose() * jacobian);
  };
  for (const PairSeparation& pair : scratch.pairs) {
    const Separation& s = pair.separation;
    Eigen::RowVectorXd row = slack_row(pair.capsule, s.on_first, s.normal);
    if (!pair.object) row -= slack_row(pair.other, s.on_second, s.normal);
    model.add_squares(term.weight, Eigen::Matrix<double, 1, 1>(term.band_m - pair.slack()),
                      Eigen::RowVectorXd(-row));
  }
}

}  // namespace morphe
