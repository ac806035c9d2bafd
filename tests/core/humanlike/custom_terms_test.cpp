#include "core/humanlike/custom_terms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/input_error.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/support/finite_differences.hpp"

namespace morphe::humanlike {
namespace {

/// What the first tip is above z = 0.2 m, and the second joint.
class Height : public ResidualTerm {
 public:
  std::string name() const override { return "height"; }
  void residuals(const ResidualInput& posture, JointVector& r, JointRows& jacobian) const override {
    const RobotModel::Tip& tip = posture.robot.tips.front();
    const Vec3 point =
        posture.base_from_frame[static_cast<std::size_t>(tip.frame)] * tip.transform.translation();
    r.resize(2);
    r << point.z() - 0.2, posture.q[1];
    jacobian.setZero(2, posture.q.size());
    jacobian.row(0) = posture.point_jacobian(tip.frame, point).row(2);
    jacobian(1, 1) = 1;
  }
};

/// A Jacobian of one column too few.
class Short : public ResidualTerm {
 public:
  std::string name() const override { return "short"; }
  void residuals(const ResidualInput& posture, JointVector& r, JointRows& jacobian) const override {
    r.setZero(1);
    jacobian.setZero(1, posture.q.size() - 1);
  }
};

class GivenTermsOfPa10 : public testing::Test {
 protected:
  solve::Quadratic model(const JointVector& q) const {
    std::vector<Pose> poses;
    robot::forward_kinematics(robot, q, poses);
    solve::Quadratic result;
    result.reset(q.size());
    terms.add({robot, q, poses}, goal, 1, result);
    return result;
  }

  robot::Robot robot{
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table};
  FrameGoal goal;
  CustomTerms terms;
};

TEST_F(GivenTermsOfPa10, AddWeightTimesTheSumOfSquaresAndItsGradient) {
  terms.entries = {{"height", 3, nullptr}};
  ASSERT_EQ(resolve_custom_terms({std::make_shared<Short>(), std::make_shared<Height>()}, terms),
            "");
  EXPECT_EQ(terms.weight, 1);
  const JointVector q = 0.3 * (robot.lower + 2 * robot.upper);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  const double height = robot::tip_pose(robot, poses, 0).translation().z() - 0.2;
  const solve::Quadratic at = model(q);
  EXPECT_NEAR(at.value, 3 * (height * height + q[1] * q[1]), 1e-12);
  const auto value = [&](const JointVector& there) { return model(there).value; };
  EXPECT_LT((at.gradient - numeric_gradient(value, q)).norm(), 1e-6);
  EXPECT_NEAR(at.hessian(1, 1) - 6, 6 * std::pow((at.gradient[1] - 6 * q[1]) / (6 * height), 2),
              1e-9);
}

TEST_F(GivenTermsOfPa10, SayWhichNameNobodyBrings) {
  terms.entries = {{"height", 1, nullptr}, {"width", 1, nullptr}};
  EXPECT_EQ(resolve_custom_terms({std::make_shared<Height>()}, terms), "width");
}

TEST_F(GivenTermsOfPa10, RefuseAJacobianOfAnotherShape) {
  terms.entries = {{"short", 1, nullptr}};
  ASSERT_EQ(resolve_custom_terms({std::make_shared<Short>()}, terms), "");
  try {
    model(robot.lower);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("term 'short'"));
  }
}

}  // namespace
}  // namespace morphe::humanlike
