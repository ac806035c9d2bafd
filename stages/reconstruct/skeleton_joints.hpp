#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::reconstruct {

/// A recorded joint of a skeleton.
struct SkeletonJoint {
  std::vector<Vec3> position;
  std::vector<Quat> orientation;
  bool estimated = false;                            ///< true if its confidence is always 0
  bool exists() const { return !position.empty(); }  ///< true if it was recorded
};

/// Returns the joint of that name; without rows if there is none.
SkeletonJoint find_joint(const BodyStream& body, const std::string& name);

/// Returns true if the joint's orientation was ever seen.
bool has_orientation(const SkeletonJoint& joint);

/// The joints of each finger of the right hand from its base to its tip.
using Digits = std::array<std::array<SkeletonJoint, 4>, kFingerCount>;

/// Returns the finger joints of the right hand.
Digits find_digits(const BodyStream& body);

/// Returns the mean over the recording of the vector from `from` to `to` in the axes of the joint
/// `axes` (not normalised); NaN if the three are never seen together.
Vec3 mean_direction(const SkeletonJoint& axes, const SkeletonJoint& from, const SkeletonJoint& to);

/// Returns the mean distance between two joints [m]; NaN if they are never seen together.
double mean_length(const SkeletonJoint& from, const SkeletonJoint& to);

}  // namespace morphe::reconstruct
