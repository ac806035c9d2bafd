#include "stages/reconstruct/hand_frame.hpp"

namespace morphe::reconstruct {

HumanMotion reconstruct_hand(const Demonstration& demonstration, const ReconstructOptions& options,
                             const HumanOptions& human) {
  const Streams& streams = demonstration.streams;
  const bool tracked = streams.markers || streams.sensors || streams.skeleton;
  const bool hand = streams.hand && (streams.hand->kind == HandKind::keypoints ||
                                     streams.hand->kind == HandKind::glove);
  if (tracked || !hand) return reconstruct(demonstration, options, human);
  Demonstration with_wrist = demonstration;
  BodyStream& wrist = with_wrist.streams.sensors.emplace();
  wrist.names = {"wrist"};
  wrist.parents = {""};
  wrist.time = streams.hand->time;
  wrist.position = {wrist.time.size(), 1, Vec3::Zero()};
  wrist.orientation = {wrist.time.size(), 1, Quat::Identity()};
  with_wrist.sensor_offsets.reset();
  HumanMotion motion = reconstruct(with_wrist, options, human);
  motion.estimated.emplace_back("wrist");
  return motion;
}

HumanMotion transform_to_hand_frame(HumanMotion motion) {
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    const Quat hand_from_world = motion.wrist_orientation[i].conjugate();
    for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
      for (Array2D<Vec3>* points : {&motion.tip, &motion.finger_joint}) {
        Vec3& point = (*points)(i, finger);
        point = hand_from_world * (point - motion.wrist[i]);
      }
      Quat& rotation = motion.tip_orientation(i, finger);
      rotation = hand_from_world * rotation;
    }
    motion.shoulder[i] = motion.elbow[i] = unknown_point();
    if (!is_known(motion.wrist[i]) || !is_known(hand_from_world)) continue;
    motion.wrist[i].setZero();
    motion.wrist_orientation[i].setIdentity();
  }
  motion.arm_angles.resize(0, 0);
  std::erase(motion.estimated, "shoulder");
  std::erase(motion.estimated, "elbow");
  return motion;
}

}  // namespace morphe::reconstruct
