#include "stages/reconstruct/skeleton_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace morphe::reconstruct {
namespace {

/// The joints of a digit from its base to its tip.
constexpr const char* kThumbJoints[] = {"cmc", "mcp", "ip", "tip"};
constexpr const char* kFingerJoints[] = {"mcp", "pip", "dip", "tip"};

}  // namespace

SkeletonJoint find_joint(const BodyStream& body, const std::string& name) {
  SkeletonJoint joint;
  const std::ptrdiff_t k = std::ranges::find(body.names, name) - body.names.begin();
  if (k == std::ssize(body.names)) return joint;
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
    for (int k = 0; k < 4; ++k) {
      const char* joint = (finger == kThumb ? kThumbJoints : kFingerJoints)[k];
      digits[finger][k] = find_joint(body, fmt::format("right_{}_{}", kFingerNames[finger], joint));
    }
  }
  return digits;
}

Vec3 mean_direction(const SkeletonJoint& axes, const SkeletonJoint& from, const SkeletonJoint& to) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (int i = 0; i < std::ssize(axes.position); ++i) {
    const Vec3 direction = axes.orientation[i].conjugate() * (to.position[i] - from.position[i]);
    if (!is_known(direction)) continue;
    sum += direction;
    ++count;
  }
  return sum / count;
}

double mean_length(const SkeletonJoint& from, const SkeletonJoint& to) {
  double sum = 0, count = 0;
  for (int i = 0; i < std::ssize(from.position); ++i) {
    const double length = (to.position[i] - from.position[i]).norm();
    if (!std::isfinite(length)) continue;
    sum += length;
    ++count;
  }
  return sum / count;
}

}  // namespace morphe::reconstruct
