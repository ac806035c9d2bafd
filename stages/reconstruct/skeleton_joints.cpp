#include "stages/reconstruct/skeleton_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace morphe::reconstruct {
namespace {

/// The joints of a digit from its base to its tip.
constexpr const char* kThumbJoints[] = {"cmc", "mcp", "ip", "tip"};
constexpr const char* kFingerJoints[] = {"mcp", "pip", "dip", "tip"};

std::string joint_name(std::size_t finger, std::size_t joint) {
  return fmt::format("right_{}_{}", kFingerNames[finger],
                     finger == 0 ? kThumbJoints[joint] : kFingerJoints[joint]);
}

}  // namespace

SkeletonJoint find_joint(const BodyStream& body, const std::string& name) {
  SkeletonJoint joint;
  const auto found = std::ranges::find(body.names, name);
  if (found == body.names.end()) return joint;
  const auto k = static_cast<std::size_t>(found - body.names.begin());
  joint.estimated = body.confidence.rows > 0;
  for (std::size_t i = 0; i < body.position.rows; ++i) {
    joint.position.push_back(body.position(i, k));
    joint.orientation.push_back(body.orientation(i, k));
    if (joint.estimated && body.confidence(i, k) != 0) joint.estimated = false;
  }
  return joint;
}

bool has_orientation(const SkeletonJoint& joint) {
  return std::ranges::any_of(joint.orientation, [](const Quat& turn) { return is_known(turn); });
}

Digits find_digits(const BodyStream& body) {
  Digits digits;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (std::size_t joint = 0; joint < 4; ++joint) {
      digits[finger][joint] = find_joint(body, joint_name(finger, joint));
    }
  }
  return digits;
}

Vec3 mean_direction(const SkeletonJoint& axes, const SkeletonJoint& from, const SkeletonJoint& to) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < axes.position.size(); ++i) {
    const Vec3 direction = axes.orientation[i].conjugate() * (to.position[i] - from.position[i]);
    if (!is_known(direction)) continue;
    sum += direction;
    ++count;
  }
  return sum / count;
}

double mean_length(const SkeletonJoint& from, const SkeletonJoint& to) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < from.position.size(); ++i) {
    const double length = (to.position[i] - from.position[i]).norm();
    if (!std::isfinite(length)) continue;
    sum += length;
    ++count;
  }
  return sum / count;
}

}  // namespace morphe::reconstruct
