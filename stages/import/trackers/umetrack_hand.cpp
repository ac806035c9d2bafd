#include "stages/import/trackers/umetrack_hand.hpp"

#include <cmath>

#include "stages/import/recording/json_lines.hpp"

namespace morphe::imports {
namespace {

constexpr double kMillimetre = 0.001;
using Affine = Eigen::Affine3d;  // a right hand's is a reflection

Vec3 row(const std::vector<double>& numbers, std::size_t k) {
  return {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
}

/// Returns all rows, at least those in use: the last two joints are the wrist's, which stay at 0.
std::vector<double> rows(const JsonNode& model, const char* key, std::size_t count) {
  return model.at(key).numbers(3 * count);
}

}  // namespace

UmetrackHand read_umetrack_hand(const std::filesystem::path& profile) {
  const nlohmann::json json = read_json(profile);
  const JsonNode top{profile.string(), 0, "", &json};
  const JsonNode model = top.at("hand_model");
  UmetrackHand hand;
  const auto axes = rows(model, "joint_rotation_axes", UmetrackHand::kAngleCount);
  const auto points = rows(model, "joint_rest_positions", UmetrackHand::kAngleCount);
  for (std::size_t k = 0; k < UmetrackHand::kFingerJointCount; ++k) {
    hand.axis[k] = row(axes, k);
    if (!(std::abs(hand.axis[k].norm() - 1) < 0.01)) {
      model.at("joint_rotation_axes").fail("must be of unit length");
    }
    hand.axis[k].normalize();
    hand.point[k] = kMillimetre * row(points, k);
  }
  const auto rest = rows(model, "landmark_rest_positions", UmetrackHand::kLandmarkCount);
  const auto bones = rows(model, "landmark_rest_bone_indices", UmetrackHand::kLandmarkCount);
  const auto weights = rows(model, "landmark_rest_bone_weights", UmetrackHand::kLandmarkCount);
  for (std::size_t k = 0; k < UmetrackHand::kLandmarkCount; ++k) {
    UmetrackHand::Landmark& landmark = hand.landmarks[k];
    landmark.rest = kMillimetre * row(rest, k);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double bone = bones[3 * k + i];
      landmark.weight[i] = weights[3 * k + i];
      sum += landmark.weight[i];
      if (landmark.weight[i] == 0) continue;  // the index of a bone without weight is unused
      if (bone != std::floor(bone) || bone < 0 || bone >= UmetrackHand::kBoneCount) {
        model.at("landmark_rest_bone_indices").fail("must be whole numbers from 0 to 16");
      }
      landmark.bone[i] = static_cast<std::size_t>(bone);
    }
    if (!(std::abs(sum - 1) < 0.01)) {
      model.at("landmark_rest_bone_weights").fail("the weights of a landmark must sum to 1");
    }
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
  for (std::size_t finger = 0; finger < 5; ++finger) {
    Affine here = root;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t joint = 4 * finger + k;
      const Vec3& about = hand.point[joint];
      here = here * Eigen::Translation3d(about) *
             Eigen::AngleAxisd(angles[joint], hand.axis[joint]) * Eigen::Translation3d(-about);
      if (joint == 0) points.thumb_cmc = here * hand.point[1];
      if (k > 0) bones[2 + 3 * finger + k - 1] = here;
    }
  }
  for (std::size_t k = 0; k < points.landmarks.size(); ++k) {
    const UmetrackHand::Landmark& landmark = hand.landmarks[k];
    points.landmarks[k].setZero();
    for (std::size_t i = 0; i < 3; ++i) {
      if (landmark.weight[i] == 0) continue;
      points.landmarks[k] += landmark.weight[i] * (bones[landmark.bone[i]] * landmark.rest);
    }
  }
  return points;
}

}  // namespace morphe::imports
