#pragma once

#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// The flange to which a hand is mounted: z along the last axis, outwards (away from the preceding
/// joints), x as in the link that the file has there.
struct Flange {
  /// The index of the frame to which the flange is fixed.
  int frame = -1;
  /// The pose of the flange in the frame.
  Pose frame_from_flange = Pose::Identity();
  /// The certainty of the pose.
  Provenance sure = Provenance::derived;
};
/// Finds the flange of an arm.
Flange find_flange(const Kinematics& robot, const std::vector<int>& arm);

}  // namespace morphe::setup
