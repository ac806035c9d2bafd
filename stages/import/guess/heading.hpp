#pragma once

#include <optional>
#include <string>

#include "stages/import/guess/body_cues.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// The heading of a person, estimated from the body.
struct HeadingEstimate {
  double yaw_rad = 0;  ///< rotation about Z after which the person faces Y [rad], in (-pi, pi]
  CueSource source = CueSource::trunk;  ///< the part of the body that gave the cues
  double agreement = 1;          ///< 1 if all cues give the same yaw, 0 if they cancel each other
  bool heading_changes = false;  ///< true if the person turns; the first second at rest is used
  std::string reason;            ///< half a sentence
};

/// Estimates the yaw that maximises the sum of weight · <world, Rz(yaw) recorded> over the
/// horizontal parts of the cues (body_cues.hpp) of one source: the most reliable source that has
/// horizontal cues in the frames at rest or, failing that, in all frames. Z of the points must be
/// up; `hand` is the recorded hand. Returns no value without horizontal cues.
std::optional<HeadingEstimate> estimate_heading(const RecordedPoints& points, Side hand);

/// Rotates a recording, its calibration and its objects about the vertical, so that the person
/// faces Y. Keeps the heading if `given.forward` is `recorded`, if its cues are missing or
/// contradict each other, or if `given` has axes and the trunk was not recorded. Adds notes on the
/// rotation, on contradictory cues, and on axes, unless `given`, along which an upright body does
/// not face. Keypoints without an arm and reconstructed skeletons are unchanged.
void align_heading(const Conventions& given, Demonstration& demonstration);

}  // namespace morphe::imports
