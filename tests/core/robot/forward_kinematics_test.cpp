// Forward kinematics against products of 4 x 4 matrices, written out here from the published
// tables and not from the YAML.
#include "core/robot/forward_kinematics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "tests/core/robot/files/generated_products.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

constexpr double kPi = std::numbers::pi;

struct Row {
  double alpha, a, d;
};
/// Modified: alpha and a of the link before.
constexpr std::array<Row, 7> kPa10 = {{{0, 0, 0.317},
                                       {-kPi / 2, 0, 0},
                                       {kPi / 2, 0, 0.45},
                                       {-kPi / 2, 0, 0},
                                       {kPi / 2, 0, 0.48},
                                       {-kPi / 2, 0, 0},
                                       {kPi / 2, 0, 0.07}}};
constexpr std::array<Row, 7> kWam = {{{0, 0, 0.31},
                                      {-kPi / 2, 0, 0},
                                      {kPi / 2, 0, 0.55},
                                      {-kPi / 2, 0.045, 0},
                                      {kPi / 2, -0.045, 0.3},
                                      {-kPi / 2, 0, 0},
                                      {kPi / 2, 0, 0.06}}};
/// Standard.
constexpr std::array<Row, 4> kFinger = {
    {{kPi / 2, 0, 0}, {0, 0.055, 0}, {0, 0.025, 0}, {0, 0.025, 0}}};

Mat4 modified_dh(const Row& r, double q) {
  const double ca = std::cos(r.alpha), sa = std::sin(r.alpha), c = std::cos(q), s = std::sin(q);
  Mat4 m;
  m << c, -s, 0, r.a,                  //
      s * ca, c * ca, -sa, -r.d * sa,  //
      s * sa, c * sa, ca, r.d * ca,    //
      0, 0, 0, 1;
  return m;
}

Mat4 standard_dh(const Row& r, double q) {
  const double ca = std::cos(r.alpha), sa = std::sin(r.alpha), c = std::cos(q), s = std::sin(q);
  Mat4 m;
  m << c, -s * ca, s * sa, r.a * c,  //
      s, c * ca, -c * sa, r.a * s,   //
      0, sa, ca, r.d,                //
      0, 0, 0, 1;
  return m;
}

/// Fixed-axis roll, pitch, yaw, as a URDF means them.
Mat4 base_of(double x, double y, double z, double roll, double pitch, double yaw) {
  const double cr = std::cos(roll), sr = std::sin(roll), cp = std::cos(pitch), sp = std::sin(pitch),
               cy = std::cos(yaw), sy = std::sin(yaw);
  Mat4 m;
  m << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, x,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, y,   //
      -sp, cp * sr, cp * cr, z,                                     //
      0, 0, 0, 1;
  return m;
}

const std::vector<std::pair<std::string, Mat4>>& finger_bases() {
  static const std::vector<std::pair<std::string, Mat4>> bases = {
      {"thumb", base_of(0.062569, 0.044545, 0.080045, 0.22581, -1.083656, 0.411355)},
      {"index", base_of(-0.00253, 0.0368, 0.108744, 175 * kPi / 180, -kPi / 2, 0)},
      {"middle", base_of(-0.0037, 0.01, 0.119044, kPi, -kPi / 2, 0)},
      {"ring", base_of(-0.00253, -0.0168, 0.114044, -175 * kPi / 180, -kPi / 2, 0)},
      {"little", base_of(0.000972, -0.043396, 0.095044, -170 * kPi / 180, -kPi / 2, 0)}};
  return bases;
}

Mat4 flange(const std::array<Row, 7>& rows, const JointVector& q) {
  Mat4 m = Mat4::Identity();
  for (std::size_t i = 0; i < 7; ++i) m *= modified_dh(rows[i], q[static_cast<Eigen::Index>(i)]);
  return m;
}

Mat4 finger_tip(const Mat4& base, double abduction, double proximal, double middle) {
  return base * standard_dh(kFinger[0], abduction) * standard_dh(kFinger[1], proximal) *
         standard_dh(kFinger[2], middle) * standard_dh(kFinger[3], middle);
}

/// A pad's frame at a finger's end: z along the last bone (x of its row), x out of the pad (y).
Mat4 end_from_pad() {
  Mat4 m;
  m << 0, 0, 1, 0,  //
      1, 0, 0, 0,   //
      0, 1, 0, 0,   //
      0, 0, 0, 1;
  return m;
}

/// All tips of a hand on base_from_palm whose first joint is `first`.
std::map<std::string, Mat4> hand_tips(const Mat4& base_from_palm, const JointVector& q,
                                      Eigen::Index first) {
  std::map<std::string, Mat4> tips;
  for (const auto& [name, base] : finger_bases()) {
    tips[name + "_tip"] =
        finger_tip(base_from_palm * base, q[first], q[first + 1], q[first + 2]) * end_from_pad();
    first += 3;
  }
  return tips;
}

/// Of every shipped robot of tables; those of URDFs have a test of their own.
std::map<std::string, Mat4> published_tips(const std::string& robot, const JointVector& q) {
  if (robot == "pa10") return {{"wrist", flange(kPa10, q)}};
  if (robot == "wam") return {{"wrist", flange(kWam, q)}};
  if (robot == "arm21") return {{"wrist", arm_product(21, 0.577, q)}};
  if (robot == "dlr_hit2") return hand_tips(Mat4::Identity(), q, 0);
  if (robot == "pa10_dlr_hit2") return hand_tips(flange(kPa10, q) * shift(0, 0, 0.03), q, 7);
  std::map<std::string, Mat4> tips = hand_products(0.205, 0.0913, q.data() + 24);
  for (auto& [name, tip] : tips) tip = arm_product(24, 0.577, q) * tip;
  return tips;
}

class Published : public testing::TestWithParam<std::string> {};

TEST_P(Published, EveryTipIsTheProductOfTheTables) {
  const RobotModel robot = shipped_robot(GetParam());
  std::mt19937 random(1);
  std::vector<Pose> base_from_frame;
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    const JointVector q = random_position(robot, random);
    const std::map<std::string, Mat4> expected = published_tips(GetParam(), q);
    ASSERT_EQ(expected.size(), robot.tips.size());
    forward_kinematics(robot, q, base_from_frame);
    for (const auto& [name, base_from_tip] : expected) {
      const std::size_t tip = tip_named(robot, name);
      ASSERT_LT(tip, robot.tips.size()) << name;
      const Mat4 ours = tip_pose(robot, base_from_frame, tip).matrix();
      worst = std::max(worst, (ours - base_from_tip).cwiseAbs().maxCoeff());
    }
  }
  EXPECT_LT(worst, 1e-12);
}
INSTANTIATE_TEST_SUITE_P(Robots, Published,
                         testing::Values("pa10", "wam", "arm21", "dlr_hit2", "pa10_dlr_hit2",
                                         "arm24_hand5"),
                         [](const auto& instance) { return instance.param; });

TEST(Forward, StretchedPa10StandsStraightUp) {
  const RobotModel robot = shipped_robot("pa10");
  std::vector<Pose> base_from_frame;
  forward_kinematics(robot, zero_position(robot), base_from_frame);
  const Pose flange = tip_pose(robot, base_from_frame, 0);
  EXPECT_LT((flange.translation() - Vec3(0, 0, 0.317 + 0.45 + 0.48 + 0.07)).norm(), 1e-15);
  EXPECT_TRUE(flange.linear().isIdentity(1e-15));
  const Vec3 shoulder =
      base_from_frame[static_cast<std::size_t>(robot.shoulder_frame)].translation();
  EXPECT_LT((shoulder - Vec3(0, 0, 0.317)).norm(), 1e-15);
}

TEST(Forward, AnyAxisAndFixedFrames) {
  RobotModel robot;
  robot.joint_names = {"a"};
  const Vec3 axis = Vec3(1, 2, -2) / 3;
  robot.frames.resize(3);
  robot.frames[0].axis = axis;
  robot.frames[0].joint = 0;
  robot.frames[0].ratio = -2;
  robot.frames[0].offset = 0.3;
  robot.frames[1].parent = 0;
  robot.frames[1].transform.translation() = Vec3(1, 2, 3);
  robot.frames[1].offset = 5;  // of no joint: does not turn
  robot.frames[2].parent = -1;
  robot.frames[2].axis = -Vec3::UnitZ();
  robot.frames[2].joint = 0;
  const JointVector q = JointVector::Constant(1, 0.7);
  std::vector<Pose> base_from_frame;
  forward_kinematics(robot, q, base_from_frame);
  const Quat turn(Eigen::AngleAxisd(-2 * 0.7 + 0.3, axis));
  EXPECT_LT((base_from_frame[1].translation() - turn * Vec3(1, 2, 3)).norm(), 1e-14);
  EXPECT_LT((base_from_frame[1].linear() - turn.toRotationMatrix()).norm(), 1e-14);
  EXPECT_NEAR(base_from_frame[2].linear()(0, 1), std::sin(0.7), 1e-15);
}

TEST(Forward, RotationsStayRotations) {
  const RobotModel robot = shipped_robot("pa10_dlr_hit2");
  std::mt19937 random(2);
  std::vector<Pose> base_from_frame;
  for (int i = 0; i < 20; ++i) {
    forward_kinematics(robot, random_position(robot, random), base_from_frame);
    for (const Pose& pose : base_from_frame) {
      EXPECT_TRUE(pose.linear().isUnitary(1e-13));
      EXPECT_GT(pose.linear().determinant(), 0);
    }
  }
}

}  // namespace
}  // namespace morphe::robot
