#include "core/robot/files/urdf_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace morphe::robot {
namespace {

/// Returns roll, pitch, yaw with R = Rz(yaw) Ry(pitch) Rx(roll). It is exact at a pitch of ±90
/// degrees too: yaw is then arbitrary, and roll makes up for it.
Vec3 rpy_of(const Eigen::Matrix3d& r) {
  const double yaw = std::atan2(r(1, 0), r(0, 0));
  const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
  const Eigen::Matrix3d rolled =
      (Eigen::AngleAxisd(-pitch, Vec3::UnitY()) * Eigen::AngleAxisd(-yaw, Vec3::UnitZ()))
          .toRotationMatrix() *
      r;
  return {std::atan2(rolled(2, 1), rolled(1, 1)), pitch, yaw};
}

}  // namespace

std::string urdf_numbers(const Vec3& vector) {
  const Vec3 unsigned_zeros = vector.array() + 0.0;  // writes 0 for -0
  return fmt::format("{} {} {}", unsigned_zeros.x(), unsigned_zeros.y(), unsigned_zeros.z());
}

std::string urdf_origin(const Pose& pose) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", urdf_numbers(pose.translation()),
                     urdf_numbers(rpy_of(pose.linear())));
}

}  // namespace morphe::robot
