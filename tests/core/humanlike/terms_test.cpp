#include "core/humanlike/terms.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/humanlike/frame_objective.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/sliding_robot.hpp"
#include "tests/support/finite_differences.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::humanlike {
namespace {

/// One property for every term: its gradient is that of its value.
class Terms : public testing::Test {
 protected:
  Terms() : robot(robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table) {
    goal.tip_position.assign(robot.tips.size(), unknown_point());
    goal.tip_orientation.assign(robot.tips.size(), unknown_rotation());
    goal.finger_joint.fill(unknown_point());
  }

  void set_pad_normals() {
    goal.tip_to_pad_share.assign(robot.tips.size(), 0.5);
    goal.pad_normal.assign(robot.tips.size(), unknown_point());
    goal.pad_normal[0] = Vec3(1, 2, -2) / 3;
    goal.pad_normal[2] = -Vec3::UnitY();
  }

  void set_every_goal() {
    for (std::size_t i = 0; i < robot.tips.size(); ++i) {
      const double shift = 0.1 * static_cast<double>(i);
      goal.tip_position[i] = Vec3(0.3 + shift, -0.2, 0.5);
      goal.tip_orientation[i] = Quat(1, 0.2 + shift, -0.3, 0.4).normalized();
    }
    goal.elbow = Vec3(0.1, 0.2, 0.3);
    goal.hand = Quat(0.3, -0.5, 0.2, 0.8).normalized();
    for (Vec3& joint : goal.finger_joint) joint = Vec3(0.3, 0.1, 0.4);
  }

  template <Term T>
  double value(const T& term, const JointVector& q) const {
    return model(term, q).value;
  }

  template <Term T>
  solve::Quadratic model(const T& term, const JointVector& q) const {
    std::vector<Pose> poses;
    robot::forward_kinematics(robot, q, poses);
    solve::Quadratic result;
    result.reset(q.size());
    const RobotState state{robot, q, poses};
    if constexpr (JointTerm<T>) {
      term.add(state, goal, term.weight, result);
    } else {
      Loads loads;
      LoadSweep sweep;
      loads.reset(robot.frames.size(), curvature);
      term.add(state, goal, term.weight, loads);
      add_derivatives(robot, poses, loads, sweep, result);
    }
    return result;
  }

  template <Term T>
  void expect_gradient(const T& term) const {
    std::mt19937_64 random(7);
    for (int i = 0; i < 20; ++i) {
      const JointVector q = random_position(robot, random);
      const solve::Quadratic analytic = model(term, q);
      EXPECT_GT(analytic.value, 0);
      const JointVector numeric =
          numeric_gradient([&](const JointVector& at) { return value(term, at); }, q);
      const double scale = std::max(1.0, numeric.cwiseAbs().maxCoeff());
      EXPECT_LT((analytic.gradient - numeric).cwiseAbs().maxCoeff(), 1e-6 * scale);
      EXPECT_LT((analytic.hessian - analytic.hessian.transpose()).cwiseAbs().maxCoeff(), 1e-9);
    }
  }

  void expect_exact_hessian(const FrameObjective& objective) const;

  robot::Robot robot;
  FrameGoal goal;
  Curvature curvature = Curvature::gauss_newton;
};

/// The exact Hessian against differences of the gradient.
TEST_F(Terms, ExactHessian) {
  set_every_goal();
  goal.tip_position[4] = unknown_point();
  FrameObjective objective;
  objective.get<TipPosition>().weight = 1000;
  objective.get<TipOrientation>() = {0.5, 1e-3};
  set_pad_normals();
  objective.get<PadDirection>().weight = 0.7;
  objective.get<JointDistance>().weight = objective.get<FingerJointDistance>().weight = 1;
  objective.get<NaturalPosture>().weight = 1e-3;
  objective.get<NaturalPosture>().joints = {{19, 16, 0.1, {4}}};
  expect_exact_hessian(objective);
}

/// Joints that slide, turn, and copy one another.
TEST_F(Terms, ExactHessianOfARobotThatSlides) {
  robot = robot::Robot(robot::sliding_robot());
  goal.tip_position.resize(1);
  goal.tip_orientation.resize(1);
  set_every_goal();
  FrameObjective objective;
  objective.get<TipPosition>().weight = 1000;
  objective.get<TipOrientation>() = {0.5, 1e-3};
  expect_exact_hessian(objective);
  expect_gradient(TipPosition{1000});
}

void Terms::expect_exact_hessian(const FrameObjective& objective) const {
  std::mt19937_64 random(11);
  const auto n = static_cast<Eigen::Index>(robot.joints());
  for (int i = 0; i < 20; ++i) {
    const JointVector q = random_position(robot, random);
    ObjectiveScratch scratch;
    solve::Quadratic exact;
    const auto evaluate = [&](const JointVector& at) {
      exact.reset(n);
      add_objective(objective, robot, at, goal, scratch, exact, Curvature::exact);
      return exact;
    };
    evaluate(q);
    evaluate(q);  // only now slopes and forces are known
    const Eigen::MatrixXd hessian = exact.hessian;
    Eigen::MatrixXd numeric(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      JointVector up = q, down = q;
      up[j] += 1e-6;
      down[j] -= 1e-6;
      numeric.col(j) = (evaluate(up).gradient - evaluate(down).gradient) / 2e-6;
    }
    EXPECT_LT((hessian - numeric).cwiseAbs().maxCoeff(), 1e-6 * numeric.cwiseAbs().maxCoeff());
    EXPECT_LT((hessian - hessian.transpose()).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST_F(Terms, TipPosition) {
  set_every_goal();
  expect_gradient(TipPosition{1000});
}
TEST_F(Terms, ThumbDistance) {
  set_every_goal();
  goal.hand_scale = 4;  // the human's tips are 25, 50, 75 mm and 0.1 m from its thumb's
  ThumbDistance term;
  term.weight = 1000;
  expect_gradient(term);
  // Fingers that are far, or whose goal is not seen, ask for nothing.
  for (std::size_t i = 1; i < robot.tips.size(); ++i) {
    if (i != 1) goal.tip_position[i] = unknown_point();
  }
  std::mt19937_64 random(3);
  const JointVector q = random_position(robot, random);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  const Vec3 thumb = robot::tip_pose(robot, poses, 0).translation();
  const Vec3 index = robot::tip_pose(robot, poses, 1).translation();
  const double off = (thumb - index).norm() - 0.025;
  EXPECT_NEAR(value(term, q), 1000 * off * off, 1e-9);
  goal.hand_scale = 1;
  EXPECT_EQ(value(term, q), 0);
  EXPECT_EQ(term.proximity_weight(0.04), 1);
  EXPECT_NEAR(term.proximity_weight(0.05), 0.5, 1e-12);
  EXPECT_EQ(term.proximity_weight(0.06), 0);
}
TEST_F(Terms, TipOrientation) {
  set_every_goal();
  expect_gradient(TipOrientation{0.01});
}
TEST_F(Terms, PadDirection) {
  set_every_goal();
  set_pad_normals();
  expect_gradient(PadDirection{0.3});
}
TEST_F(Terms, JointDistance) {
  set_every_goal();
  expect_gradient(JointDistance{1});
}
TEST_F(Terms, FingerJointDistance) {
  set_every_goal();
  expect_gradient(FingerJointDistance{1});
}
TEST_F(Terms, PalmDirection) {
  set_every_goal();
  expect_gradient(PalmDirection{0.15});
  FrameObjective objective;
  objective.get<TipPosition>().weight = 1000;
  objective.get<PalmDirection>().weight = 0.15;
  expect_exact_hessian(objective);
}

TEST_F(Terms, PalmDirectionIsTheChordsOfTwoAxes) {
  set_every_goal();
  std::mt19937_64 random(5);
  const JointVector q = random_position(robot, random);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  const Quat palm(poses[robot.palm_frame].linear());
  const double angle = 0.7;
  const auto turned = [&](const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)) * palm; };
  const double chord = 4 * std::pow(std::sin(angle / 2), 2);
  goal.hand = palm;
  EXPECT_NEAR(value(PalmDirection{1}, q), 0, 1e-12);
  goal.hand = turned(palm * Vec3::UnitX());  // both axes turn
  EXPECT_NEAR(value(PalmDirection{1}, q), 2 * chord, 1e-12);
  goal.hand = turned(palm * Vec3::UnitZ());  // the pointing axis stays
  EXPECT_NEAR(value(PalmDirection{1}, q), chord, 1e-12);
  goal.hand = Quat(Eigen::AngleAxisd(std::numbers::pi, palm * Vec3::UnitX())) * palm;
  EXPECT_NEAR(value(PalmDirection{1}, q), 8, 1e-12);  // the largest value
}

TEST_F(Terms, HandOrientation) {
  goal.hand = Quat(0.3, -0.5, 0.2, 0.8).normalized();
  expect_gradient(HandOrientation{0.01});
}
TEST_F(Terms, NaturalPosture) {
  NaturalPosture posture{1e-3, {}};
  posture.joints = {{12, 9, 0.1, {2}}, {13, -1, 0.2, {2}}};
  expect_gradient(posture);
}

TEST_F(Terms, PadDirectionIsTheChordBetweenPadAndNormal) {
  const JointVector q = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  const Eigen::Matrix3d tip = robot::tip_pose(robot, poses, 1).linear();
  goal.tip_to_pad_share.assign(robot.tips.size(), 0.5);
  goal.pad_normal.assign(robot.tips.size(), unknown_point());
  const double angle = 40 * std::numbers::pi / 180;
  goal.pad_normal[1] = tip * Vec3(std::cos(angle), 0, std::sin(angle));
  EXPECT_NEAR(value(PadDirection{1}, q), 0.5 * 4 * std::pow(std::sin(angle / 2), 2), 1e-12);
  goal.pad_normal[1] = tip.col(0);
  EXPECT_NEAR(value(PadDirection{1}, q), 0, 1e-12);
}

TEST_F(Terms, OrientationCountsHalfTheAngle) {
  // The goal is the tip itself turned by 40 degrees: Eq. (2) gives 20 degrees.
  const JointVector q = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, q, poses);
  const double angle = 40 * std::numbers::pi / 180;
  goal.tip_orientation[0] = Quat(Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized())) *
                            Quat(robot::tip_pose(robot, poses, 0).linear());
  TipOrientation term;
  term.weight = 1;
  EXPECT_NEAR(value(term, q), angle / 2, 2e-6);  // smoothing of 1e-3 adds 1.4e-6
}

TEST_F(Terms, JointDistanceIsTheMeanOverElbowAndWrist) {
  const JointVector q = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  goal.elbow = Vec3(0.1, 0, 0.317 + 0.45);  // the stretched arm's elbow is at z = 0.767
  EXPECT_NEAR(value(JointDistance{1}, q), 0.5 * (0.01 + 0.01 + 0.48 * 0.48), 1e-12);
}

TEST_F(Terms, WithThreeTipsSeenTheHandIsFree) {
  set_every_goal();
  const JointVector q = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  EXPECT_EQ(value(HandOrientation{1}, q), 0);
}

TEST_F(Terms, UnseenGoalsAddNothing) {
  const JointVector q = JointVector::Constant(static_cast<Eigen::Index>(robot.joints()), 0.1);
  FrameObjective objective;
  objective.for_each_term([](auto& term) { term.weight = 1; });
  ObjectiveScratch scratch;
  solve::Quadratic result;
  result.reset(q.size());
  add_objective(objective, robot, q, goal, scratch, result);
  EXPECT_EQ(result.value, 0);
  EXPECT_EQ(result.gradient.norm(), 0);
}

TEST_F(Terms, PostureIsForFingersWithoutAGoal) {
  NaturalPosture posture;
  posture.weight = 1;
  posture.joints = {{8, -1, 0.2, {0}}};
  const JointVector q = JointVector::Zero(static_cast<Eigen::Index>(robot.joints()));
  EXPECT_NEAR(value(posture, q), 0.04, 1e-15);
  EXPECT_NEAR(posture.distance(q, goal), 0.2, 1e-15);
  goal.tip_position[0] = Vec3::Zero();
  EXPECT_EQ(value(posture, q), 0);
  EXPECT_TRUE(std::isnan(posture.distance(q, goal)));
}

}  // namespace
}  // namespace morphe::humanlike
