#include "stages/import/trackers/hand_clip.hpp"

#include <iterator>

#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

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
    if (any_known(joint.position)) joints.push_back(std::move(joint));
  }
  if (!any_known(hand.orientation)) return;
  SkeletonJoint joint{std::string(name_of(side)) + "_hand", {}, hand.orientation, hand.confidence};
  for (std::size_t i = 0; i < rows; ++i) joint.position.push_back(hand.keypoints(i, 0));
  joints.push_back(std::move(joint));
}

}  // namespace

int name_index(const std::vector<std::string>& names, std::string_view name) {
  for (int k = 0; k < std::ssize(names); ++k) {
    if (names[k] == name) return k;
  }
  return -1;
}

std::vector<std::string> keypoint_names(Side side) {
  const std::string prefix = std::string(name_of(side)) + "_";
  std::vector<std::string> names{prefix + "wrist"};
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    for (const std::string& joint : finger_joint_names(finger)) names.push_back(prefix + joint);
  }
  return names;
}

BodyStream unseen_body(std::vector<std::string> names, std::size_t rows) {
  BodyStream body;
  body.position = Array2D<Vec3>(rows, names.size(), unknown_point());
  body.orientation = Array2D<Quat>(rows, names.size(), unknown_rotation());
  body.names = std::move(names);
  return body;
}

void set_pose(const Pose& pose, std::size_t row, std::size_t joint, BodyStream& body) {
  body.position(row, joint) = pose.translation();
  body.orientation(row, joint) = Quat(pose.linear());
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
    auto& hand = clip.hands[side_index(side)];
    if (hand) add_hand(std::move(*hand), side, joints);
  }
  std::vector<std::string> names;
  for (const SkeletonJoint& joint : joints) names.push_back(joint.name);
  BodyStream& skeleton = demonstration.streams.skeleton.emplace(unseen_body(names, rows));
  skeleton.time = std::move(clip.time);
  skeleton.reconstructed = clip.reconstructed;
  skeleton.parents = std::move(clip.body.parents);
  skeleton.parents.resize(joints.size());
  if (std::ranges::any_of(joints, [](const auto& joint) { return !joint.confidence.empty(); }))
    skeleton.confidence = Array2D<double>(rows, joints.size(), kUnknown);
  for (std::size_t k = 0; k < joints.size(); ++k) {
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
