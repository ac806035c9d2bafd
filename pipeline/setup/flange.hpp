#pragma once

#include <vector>

#include "pipeline/setup/find_hand.hpp"
#include "pipeline/setup/kinematics.hpp"

namespace morphe::setup {

/// Where a hand is screwed to an arm: z along the last axis, outwards (away from the joints before
/// it), x as of the link that the file has there.
struct Flange {
  int frame = -1;
  Pose frame_from_flange = Pose::Identity();
  Sure sure = Sure::derived;
};
Flange find_flange(const Kinematics& robot, const std::vector<int>& arm);

}  // namespace morphe::setup
