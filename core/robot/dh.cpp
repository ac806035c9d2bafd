#include "core/robot/dh.hpp"

namespace morphe::robot {

DhLink dh_link(DhConvention convention, const DhRow& row) {
  const Eigen::AngleAxisd twist(row.alpha, Vec3::UnitX());
  DhLink link;
  if (convention == DhConvention::modified) {
    // Rz and Tz share an axis and commute, so the translation along it may precede the rotation.
    link.before.linear() = twist.toRotationMatrix();
    link.before.translation() = Vec3(row.a, 0, 0) + link.before.linear() * Vec3(0, 0, row.d);
  } else {
    link.after.linear() = twist.toRotationMatrix();
    link.after.translation() = Vec3(row.a, 0, row.d);
  }
  return link;
}

}  // namespace morphe::robot
