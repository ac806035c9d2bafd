#include "stages/reconstruct/cluster.hpp"

#include <gtest/gtest.h>

namespace morphe::reconstruct {
namespace {

const std::vector<Vec3> kStill = {
    {0.20, 0.10, 0.30}, {0.26, 0.12, 0.31}, {0.21, 0.17, 0.29}, {0.24, 0.15, 0.36}};

std::vector<Vec3> moved(const Pose& pose, const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  for (const Vec3& point : points) result.push_back(pose * point);
  return result;
}

TEST(CompleteCluster, FillsRigidMotionExactly) {
  std::vector<std::vector<Vec3>> truth(4), tracks;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.02 * i;
    const Pose pose = make_pose(Vec3(t, 0.3 * t * t, -t),
                                Quat(Eigen::AngleAxisd(2 * t, Vec3(1, 2, 0.5).normalized())));
    const auto now = moved(pose, kStill);
    for (std::size_t k = 0; k < 4; ++k) truth[k].push_back(now[k]);
  }
  tracks = truth;
  for (std::size_t i = 0; i < 20; ++i) tracks[1][i] = unknown_point();
  for (std::size_t i = 30; i < 50; ++i) tracks[2][i] = unknown_point();
  fill_cluster_gaps(kStill, tracks);
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 50; ++i) {
      EXPECT_LT((tracks[k][i] - truth[k][i]).norm(), 1e-12) << k << " " << i;
    }
  }
}

TEST(CompleteCluster, MakesNoStepAtAGapOfADeformedCluster) {
  std::vector<std::vector<Vec3>> tracks(4, std::vector<Vec3>(30));
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 30; ++i) {
      tracks[k][i] = kStill[k] + (k == 0 ? Vec3(0.004, 0, 0) : Vec3::Zero());  // skin slid 4 mm
      if (k == 0 && i >= 10 && i < 20) tracks[k][i] = unknown_point();
    }
  }
  fill_cluster_gaps(kStill, tracks);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_LT((tracks[0][i] - kStill[0] - Vec3(0.004, 0, 0)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace morphe::reconstruct
