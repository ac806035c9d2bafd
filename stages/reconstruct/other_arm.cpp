#include "stages/reconstruct/other_arm.hpp"

#include <utility>

#include "stages/reconstruct/mirror.hpp"

namespace morphe::reconstruct {
namespace {

/// What may show the other side too.
Streams of_both_sides(const Streams& streams) {
  Streams both;
  // Beside joints, markers are those of objects.
  if (!streams.sensors && !streams.skeleton) both.markers = streams.markers;
  both.skeleton = streams.skeleton;
  return both;
}

}  // namespace

HumanMotion reconstruct_other_arm(const Demonstration& demonstration,
                                  const ReconstructOptions& options, const HumanOptions& human,
                                  Side beside) {
  Demonstration other = demonstration;
  other.hand = demonstration.hand == Side::right ? Side::left : Side::right;
  other.streams = of_both_sides(demonstration.streams);
  other.calibration = of_both_sides(demonstration.calibration);
  other.sensor_offsets.reset();
  HumanMotion motion = reconstruct(other, options, human);  // as a right arm
  return beside == Side::right ? mirrored(std::move(motion)) : motion;
}

}  // namespace morphe::reconstruct
