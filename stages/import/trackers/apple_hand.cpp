#include "stages/import/trackers/apple_hand.hpp"

#include <cctype>

#include "core/math/rigid.hpp"

namespace morphe::imports {

std::string normalized_apple_name(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c != '_') plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  constexpr std::string_view kFinger = "finger";
  if (const std::size_t begin = plain.find(kFinger); begin != std::string::npos)
    plain.erase(begin, kFinger.size());
  return plain;
}

const std::array<std::string, kKeypointCount>& apple_joints() {
  static const std::array<std::string, kKeypointCount> names = [] {
    std::array<std::string, kKeypointCount> all{"wrist"};
    std::size_t k = 1;
    for (const char* finger : kFingerNames) {
      for (const char* joint : {"knuckle", "intermediatebase", "intermediatetip", "tip"})
        all[k++] = std::string(finger) + joint;
    }
    return all;
  }();
  return names;
}

std::optional<Pose> pose_from_matrix(const std::vector<double>& numbers, bool column_major) {
  Eigen::Matrix4d m = Eigen::Map<const Eigen::Matrix4d>(numbers.data());
  if (!column_major) m.transposeInPlace();
  const Eigen::Matrix3d rotation = m.topLeftCorner<3, 3>();
  const bool rigid =
      m.allFinite() && rotation.determinant() > 0 &&
      (rotation.transpose() * rotation).isApprox(Eigen::Matrix3d::Identity(), 0.01) &&
      m.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), 1e-6);
  if (!rigid) return std::nullopt;
  Pose pose = Pose::Identity();
  pose.linear() = math::nearest_rotation(rotation);
  pose.translation() = m.topRightCorner<3, 1>();
  return pose;
}

}  // namespace morphe::imports
