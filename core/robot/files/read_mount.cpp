#include <fmt/format.h>

#include <cmath>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

constexpr double kOrthonormalTolerance = 1e-4;  ///< for published matrices and quaternions

Eigen::Matrix3d rotation_from(const Eigen::Matrix3d& rounded, const config::ConfigNode& node) {
  const Eigen::Matrix3d error = rounded.transpose() * rounded - Eigen::Matrix3d::Identity();
  if (error.cwiseAbs().maxCoeff() > kOrthonormalTolerance || rounded.determinant() < 0) {
    node.fail("must be a rotation matrix");
  }
  return Quat(rounded).normalized().toRotationMatrix();
}

void read_matrix(const config::ConfigNode& node, Pose& pose) {
  const std::vector<config::ConfigNode> rows = node.items();
  if (rows.size() != 3 && rows.size() != 4) node.fail("must have 3 rows of 3 or 4 rows of 4");
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::vector<double> values = rows[r].numbers();
    if (values.size() != rows.size()) {
      rows[r].fail(fmt::format("must have {} numbers, not {}", rows.size(), values.size()));
    }
    for (std::size_t c = 0; c < values.size(); ++c) {
      matrix(r, c) = values[c];
    }
  }
  if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) rows[3].fail("must be 0, 0, 0, 1");
  pose.linear() = rotation_from(matrix.topLeftCorner<3, 3>(), node);
  if (rows.size() == 4) pose.translation() = matrix.topRightCorner<3, 1>();
}

}  // namespace

Pose read_mount(const config::ConfigNode& node) {
  Pose pose = Pose::Identity();
  const int rotations = node.has("rpy") + node.has("quaternion") + node.has("matrix");
  if (rotations > 1) node.fail("must have only one of rpy, quaternion and matrix");
  if (node.has("rpy")) {
    const Vec3 angles = node["rpy"].vec3();
    pose.linear() = (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) *
                     Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                     Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
                        .toRotationMatrix();
  } else if (node.has("quaternion")) {
    const config::ConfigNode quaternion = node["quaternion"];
    const std::vector<double> w = quaternion.numbers();
    if (w.size() != 4) quaternion.fail(fmt::format("must have 4 numbers, not {}", w.size()));
    const Quat rotation(w[0], w[1], w[2], w[3]);
    if (std::abs(rotation.norm() - 1) > kOrthonormalTolerance)
      quaternion.fail("must have length 1");
    pose.linear() = rotation.normalized().toRotationMatrix();
  } else if (node.has("matrix")) {
    read_matrix(node["matrix"], pose);
  }
  if (node.has("position")) {
    if (!pose.translation().isZero(0))
      node["position"].fail("is already given by the matrix; remove one");
    pose.translation() = node["position"].vec3();
  }
  return pose;
}

Pose read_optional_mount(const config::ConfigNode& owner) {
  return owner.has("mount") ? read_mount(owner["mount"]) : Pose::Identity();
}

}  // namespace morphe::robot
