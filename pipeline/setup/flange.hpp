#pragma once

#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// The flange to which a hand is mounted: z along the last axis, outwards; x near that of the link.
struct Flange {
  int frame = -1;  ///< frame to which the flange is fixed
  Pose frame_from_flange = Pose::Identity();
  Provenance sure = Provenance::derived;
};
/// Finds the flange of an arm with these moving frames; there must be one.
Flange find_flange(const Kinematics& robot, const std::vector<int>& arm);

}  // namespace morphe::setup
