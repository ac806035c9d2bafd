#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::reconstruct {

/// A marker recording of an exactly rigid arm, and the truth behind it. The static pose: the arm
/// stretched forward, thumb up, palm to the left.
struct SyntheticArm {
  Demonstration demonstration;
  double upper_arm = 0.28;
  std::vector<Vec3> shoulder, elbow, wrist, thumb, index;
  std::vector<Quat> world_from_hand;
};

inline SyntheticArm synthetic_arm() {
  SyntheticArm arm;
  const Vec3 shoulder(0.2, -0.3, 0.35), elbow(0.2, -0.02, 0.35), wrist(0.2, 0.23, 0.35);
  const Vec3 corners[4] = {
      {0.04, 0, 0.01}, {0.05, 0.05, 0}, {0.03, 0.01, 0.06}, {0.06, 0.04, 0.05}};
  const std::string clusters[3] = {"RUAR", "RLAR", "RHAN"};
  const Vec3 origins[3] = {(shoulder + elbow) / 2, (elbow + wrist) / 2, wrist};

  MarkerStream still, moving;
  std::vector<Vec3> points;
  std::vector<int> segment;  // -1: static trial only
  const auto add = [&](const std::string& name, const Vec3& point, int carried_by) {
    still.names.push_back(name);
    points.push_back(point);
    segment.push_back(carried_by);
  };
  for (int s = 0; s < 3; ++s) {
    for (int k = 0; k < 4; ++k) {
      add(clusters[s] + std::to_string(k + 1), origins[s] + corners[k], s);
    }
  }
  add("RGTH", shoulder, -1);
  add("RLEP", elbow + Vec3(0.04, 0, 0), -1);
  add("RMEP", elbow - Vec3(0.04, 0, 0), -1);
  add("RSPR", wrist + Vec3(0, 0, 0.025), -1);
  add("RSPU", wrist - Vec3(0, 0, 0.025), -1);
  add("RFB", wrist + Vec3(0, 0.09, 0), -1);
  add("RTHUM", wrist + Vec3(-0.04, 0.08, 0.05), 2);
  add("RFTP", wrist + Vec3(-0.02, 0.16, -0.01), 2);
  moving.names = still.names;

  still.time = {0.0};
  still.position = Array2D<Vec3>(1, points.size(), unknown_point());
  for (std::size_t k = 0; k < points.size(); ++k) still.position(0, k) = points[k];

  const std::size_t frames = 300;
  moving.position = Array2D<Vec3>(frames, points.size(), unknown_point());
  for (std::size_t i = 0; i < frames; ++i) {
    moving.time.push_back(0.01 * static_cast<double>(i));
    const double s = std::clamp((moving.time[i] - 1.0) / 1.0, 0.0, 1.0);
    const double phase = s * s * s * (10 - 15 * s + 6 * s * s);
    const auto turn = [&](double angle, const Vec3& axis) {
      return Quat(Eigen::AngleAxisd(angle * phase, axis));
    };
    const auto about = [](const Vec3& centre, const Quat& rotation) {
      return make_pose(centre - rotation * centre, rotation);
    };
    const Pose upper = about(shoulder, turn(-0.9, Vec3::UnitX()) * turn(0.3, Vec3::UnitZ()));
    const Pose fore = upper * about(elbow, turn(1.2, Vec3::UnitX()));
    const Pose hand = fore * about(wrist, turn(0.5, Vec3::UnitY()) * turn(0.2, Vec3::UnitX()));
    const Pose poses[3] = {upper, fore, hand};
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (segment[k] >= 0) moving.position(i, k) = poses[segment[k]] * points[k];
    }
    arm.shoulder.push_back(shoulder);
    arm.elbow.push_back(upper * elbow);
    arm.wrist.push_back(fore * wrist);
    arm.thumb.push_back(moving.position(i, points.size() - 2));
    arm.index.push_back(moving.position(i, points.size() - 1));
    Eigen::Matrix3d axes;
    axes << -Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY();
    arm.world_from_hand.emplace_back(hand.linear() * axes);
  }
  arm.demonstration.name = "synthetic";
  arm.demonstration.streams.markers = std::move(moving);
  arm.demonstration.calibration.markers = std::move(still);
  return arm;
}

}  // namespace morphe::reconstruct
