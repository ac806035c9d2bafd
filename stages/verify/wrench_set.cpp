#include "stages/verify/wrench_set.hpp"

namespace morphe::verify {

Eigen::Matrix<double, 6, 4> contact_wrench_basis(const Vec3& lever, const Vec3& normal,
                                                 double friction, double torsion) {
  const Vec3 across = normal.unitOrthogonal(), along = normal.cross(across);
  Eigen::Matrix<double, 6, 4> g;
  g.topRows<3>() << normal, friction * across, friction * along, Vec3::Zero();
  g.bottomRows<3>() << lever.cross(normal), friction * lever.cross(across),
      friction * lever.cross(along), torsion * normal;
  return g;
}

Support support(const WrenchSet& pressing, const Vector6& u) {
  Support best;
  bool first = true;
  for (const Eigen::Matrix<double, 6, 4>& g : pressing.contacts) {
    const Eigen::Vector4d done = g.transpose() * u;
    const double grip = done.tail<3>().norm(), most = done[0] + grip;
    if (pressing.individually_bounded ? most <= 0 : !first && most <= best.value) continue;
    Vector6 wrench = g.col(0);
    if (grip > 0) wrench += g.rightCols<3>() * (done.tail<3>() / grip);
    if (pressing.individually_bounded) {
      best.value += most;
      best.wrench += wrench;
    } else {
      best = {most, wrench};
    }
    first = false;
  }
  return best;
}

}  // namespace morphe::verify
