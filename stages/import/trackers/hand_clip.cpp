#include "stages/import/trackers/hand_clip.hpp"

#include <algorithm>
#include <iterator>
#include <string>

#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// A column of a skeleton under construction.
struct SkeletonJoint {
  std::string name;
  std::vector<Vec3> position;
  std::vector<Quat> orientation;
  std::vector<double> confidence;
};

void add_hand(RecordedHand&& hand, Side side, std::vector<SkeletonJoint>& joints) {
  const std::vector<std::string> names = keypoint_names(side);
  const std::size_t rows = hand.keypoints.rows;
  for (std::size_t k = 0; k < kKeypointCount; ++k) {
    SkeletonJoint joint{names[k], {}, std::vector<Quat>(rows, unknown_rotation()), hand.confidence};
    for (std::size_t i = 0; i < rows; ++i) joint.position.push_back(hand.keypoints(i, k));
    if (std::ranges::any_of(joint.position, [](const Vec3& point) { return is_known(point); }))
      joints.push_back(std::move(joint));
  }
  if (std::ranges::any_of(hand.orientation, [](const Quat& turn) { return is_known(turn); })) {
    SkeletonJoint turned{
        std::string(name_of(side)) + "_hand", {}, hand.orientation, hand.confidence};
    for (std::size_t i = 0; i < rows; ++i) turned.position.push_back(hand.keypoints(i, 0));
    joints.push_back(std::move(turned));
  }
}

}  // namespace

std::vector<std::string> keypoint_names(Side side) {
  const std::string prefix = std::string(name_of(side)) + "_";
  std::vector<std::string> names{prefix + "wrist"};
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (const std::string& joint : finger_joint_names(finger)) names.push_back(prefix + joint);
  }
  return names;
}

void add_clip(HandClip&& clip, Demonstration& demonstration) {
  const std::size_t rows = clip.time.size();
  std::vector<SkeletonJoint> joints;
  for (std::size_t k = 0; k < clip.body.names.size(); ++k) {
    SkeletonJoint joint{clip.body.names[k], {}, {}, {}};
    for (std::size_t i = 0; i < rows; ++i) {
      joint.position.push_back(clip.body.position(i, k));
      joint.orientation.push_back(clip.body.orientation(i, k));
      if (clip.body.confidence.rows > 0) joint.confidence.push_back(clip.body.confidence(i, k));
    }
    joints.push_back(std::move(joint));
  }
  for (const Side side : {Side::right, Side::left}) {
    auto& hand = clip.hands[static_cast<std::size_t>(side)];
    if (hand) add_hand(std::move(*hand), side, joints);
  }
  BodyStream& skeleton = demonstration.streams.skeleton.emplace();
  skeleton.time = std::move(clip.time);
  skeleton.reconstructed = clip.reconstructed;
  skeleton.parents = std::move(clip.body.parents);
  skeleton.parents.resize(joints.size());
  skeleton.position = Array2D<Vec3>(rows, joints.size(), unknown_point());
  skeleton.orientation = Array2D<Quat>(rows, joints.size(), unknown_rotation());
  if (std::ranges::any_of(joints, [](const auto& joint) { return !joint.confidence.empty(); })) {
    skeleton.confidence = Array2D<double>(rows, joints.size(), kUnknown);
  }
  for (std::size_t k = 0; k < joints.size(); ++k) {
    skeleton.names.push_back(joints[k].name);
    for (std::size_t i = 0; i < rows; ++i) {
      skeleton.position(i, k) = joints[k].position[i];
      skeleton.orientation(i, k) = joints[k].orientation[i];
      if (!joints[k].confidence.empty()) skeleton.confidence(i, k) = joints[k].confidence[i];
    }
  }
  demonstration.objects.insert(demonstration.objects.end(),
                               std::make_move_iterator(clip.objects.begin()),
                               std::make_move_iterator(clip.objects.end()));
}

}  // namespace morphe::imports
