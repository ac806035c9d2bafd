// The DLR/HIT II hand against what is published about it besides its DH rows.
#include <gmock/gmock.h>

#include <map>
#include <numbers>

#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

Eigen::Matrix3d matrix(std::initializer_list<double> rows) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.begin());
}

/// Rotation matrices of the finger bases in the palm frame, SynGrasp.
const std::map<std::string, Eigen::Matrix3d>& published_bases() {
  static const std::map<std::string, Eigen::Matrix3d> bases = {
      {"thumb", matrix({0.429051, -0.571047, -0.699872, 0.187173, 0.814200, -0.549586, 0.883675,
                        0.104803, 0.456218})},
      {"index", matrix({0, -0.087156, 0.996195, 0, -0.996195, -0.087156, 1, 0, 0})},
      {"middle", matrix({0, 0, 1, 0, -1, 0, 1, 0, 0})},
      {"ring", matrix({0, 0.087156, 0.996195, 0, -0.996195, 0.087156, 1, 0, 0})},
      {"little", matrix({0, 0.173648, 0.984808, 0, -0.984808, 0.173648, 1, 0, 0})}};
  return bases;
}

double difference(double roll, double pitch, double yaw, const Eigen::Matrix3d& published) {
  const Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
       Eigen::AngleAxisd(roll, Vec3::UnitX()))
          .toRotationMatrix();
  return (rotation - published).cwiseAbs().maxCoeff();
}

TEST(HandGeometry, OnlyOneOfTheTwoPublishedThumbAnglesGivesThePublishedMatrix) {
  const Eigen::Matrix3d& thumb = published_bases().at("thumb");
  const double hithand_ros = difference(0.22581, -1.083656, 0.411355, thumb);
  const double dlr_hit_hand_ii = difference(0.41136, -1.08366, 0.225804, thumb);
  RecordProperty("hithand_ros", std::to_string(hithand_ros));
  RecordProperty("dlr_hit_hand_ii", std::to_string(dlr_hit_hand_ii));
  EXPECT_LT(hithand_ros, 5e-6);
  EXPECT_NEAR(dlr_hit_hand_ii, 0.0824, 1e-4);
}

TEST(HandGeometry, FingerBasesAreThePublishedMatrices) {
  const RobotModel robot = shipped_robot("dlr_hit2");
  std::vector<Pose> palm_from_frame;
  forward_kinematics(robot, zero_position(robot), palm_from_frame);
  for (const auto& [finger, published] : published_bases()) {
    const Pose& base = palm_from_frame[frame_named(robot, finger + "_abduction")];
    EXPECT_LT((base.linear() - published).cwiseAbs().maxCoeff(), 5e-6) << finger;
  }
}

TEST(HandGeometry, StretchedFingersAre105MillimetresLong) {
  const RobotModel robot = shipped_robot("dlr_hit2");
  std::vector<Pose> palm_from_frame;
  forward_kinematics(robot, zero_position(robot), palm_from_frame);
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const std::string finger = robot.tips[tip].name.substr(0, robot.tips[tip].name.find('_'));
    const Pose& base = palm_from_frame[frame_named(robot, finger + "_abduction")];
    const Vec3 base_to_tip =
        tip_pose(robot, palm_from_frame, tip).translation() - base.translation();
    EXPECT_LT((base_to_tip - 0.105 * base.linear().col(0)).norm(), 1e-15) << finger;
    EXPECT_EQ(robot.tips[tip].finger, static_cast<int>(tip));
    if (finger != "thumb") {
      EXPECT_GT(base_to_tip.normalized().z(), 1 - 1e-12) << finger;
    }
  }
}

TEST(HandGeometry, FlexionCurlsFingersOutOfThePalmAndTheThumbTowardsThem) {
  const RobotModel robot = shipped_robot("dlr_hit2");
  std::vector<Pose> palm_from_frame;
  forward_kinematics(robot, zero_position(robot), palm_from_frame);
  std::vector<Vec3> open;
  for (std::size_t tip = 0; tip < 5; ++tip) {
    open.push_back(tip_pose(robot, palm_from_frame, tip).translation());
  }
  for (const int flexion : {1, 2}) {
    JointVector q = zero_position(robot);
    for (Eigen::Index finger = 0; finger < 5; ++finger) q[3 * finger + flexion] = 0.3;
    forward_kinematics(robot, q, palm_from_frame);
    for (std::size_t tip = 0; tip < 5; ++tip) {
      const Vec3 moved = tip_pose(robot, palm_from_frame, tip).translation() - open[tip];
      if (tip == 0) {
        EXPECT_LT(moved.x(), -0.005);
        EXPECT_LT(moved.y(), -0.005);
      } else {
        EXPECT_GT(moved.x(), 0.01) << robot.tips[tip].name;
      }
    }
  }
}

TEST(HandGeometry, DistalCapsulesReachAsFarAsTheMesh) {
  const RobotModel robot = shipped_robot("dlr_hit2");
  int found = 0;
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    if (!capsule.name.ends_with("_distal")) continue;
    EXPECT_NEAR(capsule.to.x() + capsule.radius, 0.0266, 1e-15);
    ++found;
  }
  EXPECT_EQ(found, 5);
}

}  // namespace
}  // namespace morphe::robot
