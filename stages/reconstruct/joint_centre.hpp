#pragma once

#include <string>
#include <vector>

#include "stages/reconstruct/marker_body.hpp"

namespace morphe::reconstruct {

/// A joint between two bodies and the landmarks in whose middle it lies.
struct MarkerJoint {
  std::string name;                    ///< shoulder, elbow, wrist
  std::vector<std::string> landmarks;  ///< all lie on the first body
  /// Whether bones turn enough about it, and skin slides little enough, to correct a known landmark
  /// by where the two bodies turn. True of elbow and wrist: what two clusters say of them differs
  /// by 16-33 mm in the ue-adl trials, their pivots agree to 2-6 mm, and the pivots of one trial to
  /// 5-13 mm in others of the same subject. Not of the shoulder, whose pivots lie 20-45 mm from the
  /// landmark and as far from one another.
  bool pivots = true;
};

/// The joint's centre on the clock, from the best that there is:
/// - landmarks that the recording shows: their middle;
/// - landmarks of the static trial, carried by both bodies (corrected by their pivot);
/// - else the pivot of both bodies, of the first one and the world if it has no neighbour: listed
///   in `motion.estimated`, and how well it is known in `motion.problems`.
/// What two bodies disagree by goes to `motion.residuals`.
std::vector<Vec3> joint_centre(MarkerTrial& trial, const MarkerJoint& joint,
                               const MarkerBody& first, const MarkerBody& second,
                               HumanMotion& motion);

}  // namespace morphe::reconstruct
