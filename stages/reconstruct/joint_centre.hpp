#pragma once

#include <string>
#include <vector>

#include "stages/reconstruct/marker_body.hpp"

namespace morphe::reconstruct {

/// A joint between two bodies, at the mean of its landmarks.
struct MarkerJoint {
  std::string name;                    ///< shoulder, elbow, wrist
  std::vector<std::string> landmarks;  ///< all on the first body
  /// True if the motion about the joint is large enough, and skin movement small enough, to correct
  /// a known landmark by the centre of rotation of the two bodies. This holds for elbow and wrist:
  /// their positions from two clusters differ by 16-33 mm in the ue-adl trials, their centres of
  /// rotation agree to 2-6 mm, and those of one trial to 5-13 mm in others of the same subject. It
  /// does not hold for the shoulder, whose centres of rotation are 20-45 mm from the landmark and
  /// as far from one another.
  bool refine_by_motion = true;
};

/// Computes the joint's centre on the clock from the best available data:
/// - the mean of the landmarks, if the recording shows them;
/// - landmarks of the static trial, carried by both bodies (corrected by their centre of
///   rotation);
/// - otherwise the centre of rotation of both bodies, or for a shoulder without a second body
///   of the first body and the world: it is listed in `motion.estimated`, and its accuracy in
///   `motion.reconstruction_notes`.
/// The disagreement between the two bodies is added to `motion.residuals`.
std::vector<Vec3> joint_centre(MarkerTrial& trial, const MarkerJoint& joint,
                               const MarkerBody& first, const MarkerBody& second,
                               HumanMotion& motion);

}  // namespace morphe::reconstruct
