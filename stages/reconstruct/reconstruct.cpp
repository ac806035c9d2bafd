#include "stages/reconstruct/reconstruct.hpp"

#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe::reconstruct {

HumanMotion reconstruct(const Demonstration& demonstration, const ReconstructOptions& options,
                        const HumanOptions& human) {
  if (demonstration.hand == Side::left) {
    HumanMotion motion = reconstruct(mirror_image(demonstration), options, human);
    motion.reconstruction_notes.push_back("a left hand: mirrored at X = 0 into a right hand");
    return motion;
  }
  // Markers beside tracked joints belong to objects.
  const Streams& streams = demonstration.streams;
  if (streams.markers && !streams.sensors && !streams.skeleton) {
    return motion_from_markers(demonstration, options);
  }
  const auto& hand = streams.hand;
  if (streams.sensors || (hand && hand->kind == HandKind::glove)) {
    return motion_from_sensors(demonstration, options, human);
  }
  if (streams.skeleton) return motion_from_skeleton(demonstration, options, human);
  if (hand && hand->kind == HandKind::keypoints) return motion_from_hand(demonstration, options);
  HumanMotion unseen = unseen_motion({});
  unseen.reconstruction_notes.push_back(
      streams.arm_angles
          ? "joint angles only: the dimensions of the body are unknown, so no arm is reconstructed"
          : "neither markers nor tracked bodies: no arm can be reconstructed");
  return unseen;
}

}  // namespace morphe::reconstruct
