#include "stages/import/trackers/umetrack_hand.hpp"

#include <cmath>

#include "stages/import/recording/json_lines.hpp"

namespace morphe::imports {
namespace {

constexpr double kMillimetre = 0.001;
using Affine = Eigen::Affine3d;  // not a Pose: those of a right hand contain a reflection

}  // namespace

UmetrackHand read_umetrack_hand(const std::filesystem::path& profile) {
  const nlohmann::json json = read_json(profile);
  const JsonNode top{profile.string(), 0, "", &json};
  const JsonNode model = top.at("hand_model");
  // The last two of the 22 angles are the wrist's and always 0; their axes and points are not used.
  constexpr int kAxisNumbers = 3 * UmetrackHand::kAngleCount;
  constexpr int kLandmarkNumbers = 3 * UmetrackHand::kLandmarkCount;
  UmetrackHand hand;
  const auto axes = model.at("joint_rotation_axes").numbers(kAxisNumbers);
  const auto points = model.at("joint_rest_positions").numbers(kAxisNumbers);
  for (int k = 0; k < UmetrackHand::kFingerJointCount; ++k) {
    hand.axis[k] = Eigen::Map<const Vec3>(&axes[3 * k]);
    if (!(std::abs(hand.axis[k].norm() - 1) < 0.01))
      model.at("joint_rotation_axes").fail("must be of unit length");
    hand.axis[k].normalize();
    hand.point[k] = kMillimetre * Eigen::Map<const Vec3>(&points[3 * k]);
  }
  const auto rest = model.at("landmark_rest_positions").numbers(kLandmarkNumbers);
  const auto bones = model.at("landmark_rest_bone_indices").numbers(kLandmarkNumbers);
  const auto weights = model.at("landmark_rest_bone_weights").numbers(kLandmarkNumbers);
  for (int k = 0; k < UmetrackHand::kLandmarkCount; ++k) {
    UmetrackHand::Landmark& landmark = hand.landmarks[k];
    landmark.rest = kMillimetre * Eigen::Map<const Vec3>(&rest[3 * k]);
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double bone = bones[3 * k + i];
      landmark.weight[i] = weights[3 * k + i];
      sum += landmark.weight[i];
      if (landmark.weight[i] == 0) continue;  // the index of a bone without weight is unused
      if (bone != std::floor(bone) || bone < 0 || bone >= UmetrackHand::kBoneCount)
        model.at("landmark_rest_bone_indices").fail("must be whole numbers from 0 to 16");
      landmark.bone[i] = static_cast<int>(bone);
    }
    if (!(std::abs(sum - 1) < 0.01))
      model.at("landmark_rest_bone_weights").fail("the weights of a landmark must sum to 1");
  }
  return hand;
}

UmetrackPoints umetrack_forward_kinematics(const UmetrackHand& hand, Side side,
                                           const Pose& world_from_wrist,
                                           const std::vector<double>& angles) {
  UmetrackPoints points;
  Affine root(world_from_wrist.matrix());
  if (side == Side::right) root.linear().col(0) *= -1;
  std::array<Affine, UmetrackHand::kBoneCount> bones;
  bones[0] = bones[1] = root;
  for (int finger = 0; finger < 5; ++finger) {
    Affine bone = root;
    for (int k = 0; k < 4; ++k) {
      const int joint = 4 * finger + k;
      const Vec3& centre = hand.point[joint];
      bone = bone * Eigen::Translation3d(centre) *
             Eigen::AngleAxisd(angles[joint], hand.axis[joint]) * Eigen::Translation3d(-centre);
      if (joint == 0) points.thumb_cmc = bone * hand.point[1];
      if (k > 0) bones[2 + 3 * finger + k - 1] = bone;
    }
  }
  for (int k = 0; k < UmetrackHand::kLandmarkCount; ++k) {
    const UmetrackHand::Landmark& landmark = hand.landmarks[k];
    points.landmarks[k].setZero();
    for (int i = 0; i < 3; ++i) {
      if (landmark.weight[i] == 0) continue;
      points.landmarks[k] += landmark.weight[i] * (bones[landmark.bone[i]] * landmark.rest);
    }
  }
  return points;
}

}  // namespace morphe::imports
