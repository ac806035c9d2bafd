#pragma once

#include <string>
#include <vector>

#include "stages/reconstruct/marker_body.hpp"

namespace morphe::reconstruct {

/// A joint between two bodies, at the mean of its landmarks.
struct MarkerJoint {
  std::string name;                    ///< shoulder, elbow, wrist
  std::vector<std::string> landmarks;  ///< all on the first body
  /// True if known landmarks are corrected by the centre of rotation of the two bodies, which takes
  /// much motion about the joint and little skin movement. In the ue-adl trials the positions of
  /// elbow and wrist from two clusters differ by 16-33 mm, their centres of rotation agree to
  /// 2-6 mm, and those of one trial to 5-13 mm in others of the same subject; centres of rotation
  /// of the shoulder are 20-45 mm from the landmark and as far from one another.
  bool refine_by_motion = true;
};

/// Returns the joint's centre on the clock, from the first of these that is available:
/// - the mean of the landmarks, if the recording shows all of them;
/// - landmarks known in a body's frame (from the static trial), carried by the bodies and, if
///   `refine_by_motion`, corrected by their centre of rotation;
/// - the centre of rotation of both bodies, or, for a shoulder without a second body, of the first
///   body and the world. It is named in `motion.estimated`, its accuracy in
///   `motion.reconstruction_notes`.
/// Otherwise the centre is unseen, which is noted. The distance between the positions that the two
/// bodies give is added to `motion.residuals`.
std::vector<Vec3> joint_centre(MarkerTrial& trial, const MarkerJoint& joint,
                               const MarkerBody& first, const MarkerBody& second,
                               HumanMotion& motion);

}  // namespace morphe::reconstruct
