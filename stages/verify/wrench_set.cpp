#include "stages/verify/wrench_set.hpp"

namespace morphe::verify {

Eigen::Matrix<double, 6, 4> contact_wrench_basis(const Vec3& moment_arm, const Vec3& normal,
                                                 double mu, double gamma) {
  const Vec3 tangent_1 = normal.unitOrthogonal(), tangent_2 = normal.cross(tangent_1);
  Eigen::Matrix<double, 6, 4> basis;
  basis.topRows<3>() << normal, mu * tangent_1, mu * tangent_2, Vec3::Zero();
  basis.bottomRows<3>() << moment_arm.cross(normal), mu * moment_arm.cross(tangent_1),
      mu * moment_arm.cross(tangent_2), gamma * normal;
  return basis;
}

Support support(const WrenchSet& wrenches, const Vector6& u) {
  Support result;
  bool first = true;
  for (const Eigen::Matrix<double, 6, 4>& basis : wrenches.contact_bases) {
    const Eigen::Vector4d power = basis.transpose() * u;  // of each column
    const double friction_power = power.tail<3>().norm(), max_power = power[0] + friction_power;
    if (wrenches.limits_each_force ? max_power <= 0 : !first && max_power <= result.value) continue;
    Vector6 wrench = basis.col(0);
    if (friction_power > 0) wrench += basis.rightCols<3>() * (power.tail<3>() / friction_power);
    if (wrenches.limits_each_force) {
      result.value += max_power;
      result.wrench += wrench;
    } else {
      result = {max_power, wrench};
    }
    first = false;
  }
  return result;
}

}  // namespace morphe::verify
