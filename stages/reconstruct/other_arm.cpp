#include "stages/reconstruct/other_arm.hpp"

#include <utility>

#include "stages/reconstruct/mirror.hpp"

namespace morphe::reconstruct {
namespace {

Streams bilateral_streams(const Streams& streams) {
  Streams both;
  // Markers beside tracked joints belong to objects.
  if (!streams.sensors && !streams.skeleton) both.markers = streams.markers;
  both.skeleton = streams.skeleton;
  return both;
}

}  // namespace

HumanMotion reconstruct_other_arm(const Demonstration& demonstration,
                                  const ReconstructOptions& options, const HumanOptions& human,
                                  Side side) {
  Demonstration other = demonstration;
  other.hand = demonstration.hand == Side::right ? Side::left : Side::right;
  other.streams = bilateral_streams(demonstration.streams);
  other.calibration = bilateral_streams(demonstration.calibration);
  other.sensor_offsets.reset();
  HumanMotion motion = reconstruct(other, options, human);  // reconstructed as a right arm
  return side == Side::right ? mirror_image(std::move(motion)) : motion;
}

}  // namespace morphe::reconstruct
