#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

constexpr double kOrthonormalTolerance = 1e-4;  ///< of rounded matrices and quaternions

const Chain* find_chain(const Assembly& assembly, const std::string& name) {
  const auto chain = std::ranges::find(assembly.chains, name, &Chain::name);
  return chain == assembly.chains.end() ? nullptr : &*chain;
}

/// Returns the full names that a name in a file may stand for, in order of precedence.
std::array<std::string, 2> readings(const FileScope& scope, const std::string& name) {
  return {scope.prefix + name, name};
}

Eigen::Matrix3d rotation_from(const Eigen::Matrix3d& rounded, const config::ConfigNode& node) {
  const Eigen::Matrix3d error = rounded.transpose() * rounded - Eigen::Matrix3d::Identity();
  if (error.cwiseAbs().maxCoeff() > kOrthonormalTolerance || rounded.determinant() < 0)
    node.fail("must be a rotation matrix");
  return Quat(rounded).normalized().toRotationMatrix();
}

void read_matrix(const config::ConfigNode& node, Pose& pose) {
  const std::vector<config::ConfigNode> rows = node.items();
  if (rows.size() != 3 && rows.size() != 4) node.fail("must have 3 rows of 3 or 4 rows of 4");
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  for (int r = 0; r < std::ssize(rows); ++r) {
    const std::vector<double> values = rows[r].numbers(bounds::kCoordinate);
    if (values.size() != rows.size())
      rows[r].fail(fmt::format("must have {} numbers, not {}", rows.size(), values.size()));
    for (int c = 0; c < std::ssize(values); ++c) matrix(r, c) = values[c];
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
    const Vec3 angles = node["rpy"].vec3(bounds::kAngle);
    pose.linear() = (Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) *
                     Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
                     Eigen::AngleAxisd(angles.x(), Vec3::UnitX()))
                        .toRotationMatrix();
  } else if (node.has("quaternion")) {
    const config::ConfigNode quaternion = node["quaternion"];
    const std::vector<double> wxyz = quaternion.numbers(bounds::kUnit);
    if (wxyz.size() != 4) quaternion.fail(fmt::format("must have 4 numbers, not {}", wxyz.size()));
    const Quat rotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    if (std::abs(rotation.norm() - 1) > kOrthonormalTolerance)
      quaternion.fail("must have length 1");
    pose.linear() = rotation.normalized().toRotationMatrix();
  } else if (node.has("matrix")) {
    read_matrix(node["matrix"], pose);
  }
  if (node.has("position")) {
    if (!pose.translation().isZero(0))
      node["position"].fail("is already given by the matrix; remove one");
    pose.translation() = node["position"].vec3(bounds::kCoordinate);
  }
  return pose;
}

Pose read_optional_mount(const config::ConfigNode& owner) {
  return owner.has("mount") ? read_mount(owner["mount"]) : Pose::Identity();
}

bool has_frame_or_chain(const Assembly& assembly, const std::string& name) {
  return frame_index(assembly.table, name) >= 0 || find_chain(assembly, name);
}

int find_frame(const Assembly& assembly, const FileScope& scope, const std::string& name) {
  for (const std::string& reading : readings(scope, name)) {
    if (const auto link = scope.links.find(reading); link != scope.links.end()) return link->second;
    if (const int frame = frame_index(assembly.table, reading); frame >= 0) return frame;
  }
  return -1;
}

bool has_mount_point(const Assembly& assembly, const FileScope& scope, const std::string& name) {
  if (name == "base" || find_frame(assembly, scope, name) >= 0) return true;
  return std::ranges::any_of(readings(scope, name), [&](const std::string& reading) {
    return find_chain(assembly, reading) != nullptr;
  });
}

MountPoint find_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& name) {
  const std::string word = name.text();
  for (const std::string& reading : readings(scope, word)) {
    if (const Chain* chain = find_chain(assembly, reading)) return chain->end;
  }
  if (const int frame = find_frame(assembly, scope, word); frame >= 0) return {frame};
  if (word == "base") return scope.base;
  name.fail(fmt::format("there is no frame, link or chain '{}'", word));
}

MountPoint read_mount_point(const Assembly& assembly, const FileScope& scope,
                            const config::ConfigNode& node) {
  MountPoint mount =
      node.has("parent") ? find_mount_point(assembly, scope, node["parent"]) : scope.base;
  mount.frame_from_mount = mount.frame_from_mount * read_optional_mount(node);
  return mount;
}

int add_frame(Assembly& assembly, const FileScope& scope, const config::ConfigNode& name,
              RobotModel::Frame frame) {
  frame.name = scope.prefix + name.text();
  if (has_frame_or_chain(assembly, frame.name))
    name.fail(fmt::format("a frame or chain '{}' already exists", frame.name));
  return append_frame(assembly.table, std::move(frame));
}

}  // namespace morphe::robot
