#include "stages/verify/pressing.hpp"

namespace morphe::verify {

Eigen::Matrix<double, 6, 4> pressing_of(const Vec3& lever, const Vec3& normal, double friction,
                                        double torsion) {
  const Vec3 across = normal.unitOrthogonal(), along = normal.cross(across);
  Eigen::Matrix<double, 6, 4> g;
  g.topRows<3>() << normal, friction * across, friction * along, Vec3::Zero();
  g.bottomRows<3>() << lever.cross(normal), friction * lever.cross(across),
      friction * lever.cross(along), torsion * normal;
  return g;
}

Farthest farthest(const Pressing& pressing, const Vector6& u) {
  Farthest best;
  bool first = true;
  for (const Eigen::Matrix<double, 6, 4>& g : pressing.contacts) {
    const Eigen::Vector4d done = g.transpose() * u;
    const double grip = done.tail<3>().norm(), most = done[0] + grip;
    if (pressing.each ? most <= 0 : !first && most <= best.most) continue;
    Vector6 wrench = g.col(0);
    if (grip > 0) wrench += g.rightCols<3>() * (done.tail<3>() / grip);
    if (pressing.each) {
      best.most += most;
      best.wrench += wrench;
    } else {
      best = {most, wrench};
    }
    first = false;
  }
  return best;
}

}  // namespace morphe::verify
