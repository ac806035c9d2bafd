#pragma once

#include <optional>
#include <string>

#include "stages/import/guess/body_cues.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// The heading of a person, estimated from the body.
struct HeadingEstimate {
  double yaw_rad = 0;  ///< rotation about Z after which the person faces Y [rad], in (-pi, pi]
  CueSource source = CueSource::trunk;  ///< part of the body from which it was estimated
  double agreement = 1;  ///< agreement of the cues with each other; 1 if all of them are equal
  bool heading_changes = false;  ///< true if the person turns round; the first second is used
  std::string because;           ///< half a sentence
};

/// Estimates the rotation that maximises the sum over the cues of weight * <world, Rz(turn)
/// recorded>, over their horizontal parts, using the most reliable kind of cues, in the frames at
/// rest (body_cues.hpp), or in all frames if those contain no such cue. If the world is rotated by
/// an angle, the estimate changes by that angle. Returns no value if no cue is horizontal. Z of the
/// points is up; `hand` is the recorded hand.
std::optional<HeadingEstimate> estimate_heading(const RecordedPoints& points, Side hand);

/// Rotates a whole recording, its calibration and its objects about the vertical, so that the
/// person faces Y. It is not rotated if the axes determine the forward direction, if they were
/// given and the trunk was not recorded, or if the cues are missing or contradictory. A hand in a
/// frame of its own (keypoints alone) has no position and is left unchanged. Adds to `reports` the
/// action taken, and a disagreement of the body with axes that were not given.
void align_heading(const Conventions& given, Demonstration& demonstration);

}  // namespace morphe::imports
