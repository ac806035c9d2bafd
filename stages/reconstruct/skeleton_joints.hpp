#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// A joint of a skeleton as it was recorded; no rows if it has none of that name.
struct SkeletonJoint {
  std::vector<Vec3> position;
  std::vector<Quat> orientation;
  bool estimated = false;  ///< nothing of it was measured: its confidence is 0 throughout
  bool there() const { return !position.empty(); }
};

SkeletonJoint find_joint(const BodyStream& body, const std::string& name);

/// Whether it was ever seen how the joint is turned.
bool is_turned(const SkeletonJoint& joint);

/// Of the right hand: joints of each finger from its base to its tip.
using Digits = std::array<std::array<SkeletonJoint, 4>, kFingers>;

Digits find_digits(const BodyStream& body);

/// Mean over the recording of where `to` lies from `from`, in the axes of a joint.
Vec3 mean_direction(const SkeletonJoint& axes, const SkeletonJoint& from, const SkeletonJoint& to);

double mean_length(const SkeletonJoint& from, const SkeletonJoint& to);

}  // namespace morphe::reconstruct
