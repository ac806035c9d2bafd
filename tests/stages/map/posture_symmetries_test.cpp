#include "stages/map/posture_symmetries.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/robot/forward_kinematics.hpp"
#include "stages/map/map_options.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::map {
namespace {

using std::numbers::pi;

/// Five frames whose goals are a posture's own tips.
struct TwinBench {
  explicit TwinBench(const std::string& name)
      : robot(robot::shipped_robot(name)),
        world(collision::make_world(robot, scene, Movement{}, Tolerances{})) {
    posture = 0.5 * (robot.lower + robot.upper);
    for (Eigen::Index j = 0; j < posture.size(); ++j) {
      posture[j] += 0.1 * static_cast<double>(1 + j % 3) * (robot.upper[j] - posture[j]);
    }
    problem.robot = &robot;
    problem.objective = default_objective();
    problem.world = &world;
    problem.clearance.weight = 0;
    std::vector<Pose> base_from_frame;
    robot::forward_kinematics(robot, posture, base_from_frame);
    humanlike::FrameGoal goal;
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const Pose pose = robot::tip_pose(robot, base_from_frame, tip);
      goal.tip_position.push_back(pose.translation());
      goal.tip_orientation.push_back(Quat(pose.linear()));
    }
    goal.shoulder = Vec3(0.1, 0.2, 0.3);
    goal.elbow = Vec3(0.3, 0.2, 0.3);
    goal.wrist = Vec3(0.5, 0.2, 0.3);
    for (int f = 0; f < 5; ++f) {
      problem.time.push_back(0.01 * f);
      problem.goals.push_back(goal);
    }
  }

  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
  MappingProblem problem;
  JointVector posture;
};

TEST(Twins, ThePA10HasThreeFlips) {
  const TwinBench bench("pa10_dlr_hit2");
  const PostureSymmetries twins = find_posture_symmetries(bench.problem);
  ASSERT_EQ(twins.flips.size(), 3u);  // shoulder, elbow, wrist
  for (std::size_t k = 0; k < 3; ++k) {
    const auto first = static_cast<Eigen::Index>(2 * k);
    EXPECT_EQ(twins.flips[k].first, first);
    EXPECT_EQ(twins.flips[k].middle, first + 1);
    EXPECT_EQ(twins.flips[k].last, first + 2);
    EXPECT_NEAR(std::remainder(twins.flips[k].parallel_rad, pi), 0, 1e-9);
  }
}

TEST(Twins, PlaceEveryTipAndCentreAlike) {
  const TwinBench bench("pa10_dlr_hit2");
  const RobotModel& robot = bench.robot;
  const std::vector<JointVector> all =
      equivalent_postures(find_posture_symmetries(bench.problem), bench.posture);
  ASSERT_GE(all.size(), 8u);
  std::vector<Pose> as_is, twin;
  robot::forward_kinematics(robot, bench.posture, as_is);
  for (const JointVector& q : all) {
    EXPECT_TRUE((q.array() >= robot.lower.array()).all());
    EXPECT_TRUE((q.array() <= robot.upper.array()).all());
    robot::forward_kinematics(robot, q, twin);
    for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
      const Pose a = robot::tip_pose(robot, as_is, tip), b = robot::tip_pose(robot, twin, tip);
      EXPECT_TRUE(a.isApprox(b, 1e-9));
    }
    for (const RobotModel::JointCentre& centre : robot.joint_centres) {
      const auto frame = static_cast<std::size_t>(centre.frame);
      EXPECT_LT((as_is[frame].translation() - twin[frame].translation()).norm(), 1e-9);
    }
  }
}

TEST(Twins, AreAlikeAndOthersAreNot) {
  const TwinBench bench("pa10_dlr_hit2");
  const PostureSymmetries twins = find_posture_symmetries(bench.problem);
  for (const JointVector& q : equivalent_postures(twins, bench.posture)) {
    EXPECT_TRUE(same_up_to_symmetry(twins, q, bench.posture, 1e-6));
    JointVector bent = q;
    bent[3] += 0.2;
    EXPECT_FALSE(same_up_to_symmetry(twins, bent, bench.posture, 0.1));
  }
}

TEST(Twins, TheFarthestFromTheLimitsFirst) {
  const TwinBench bench("pa10_dlr_hit2");
  const PostureSymmetries twins = find_posture_symmetries(bench.problem);
  JointVector q = bench.posture;
  q[2] = bench.robot.upper[2] - 1e-3;
  const JointVector first = equivalent_postures(twins, q).front();
  EXPECT_GT(bench.robot.upper[2] - std::abs(first[2]), 0.1);
  EXPECT_TRUE(same_up_to_symmetry(twins, first, q, 1e-6));
}

TEST(Twins, ThoseOfTheReferencesSidesFirst) {
  const TwinBench bench("pa10_dlr_hit2");
  PostureSymmetries twins = find_posture_symmetries(bench.problem);
  const std::vector<JointVector> all = equivalent_postures(twins, bench.posture);
  for (const JointVector& reference : all) {
    twins.reference = reference;
    for (const JointVector& q : all)
      EXPECT_LT((equivalent_postures(twins, q).front() - reference).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(PreferredEquivalent, HasTheSidesOfTheReferenceAndTheSamePlaces) {
  const TwinBench bench("pa10_dlr_hit2");
  PostureSymmetries twins = find_posture_symmetries(bench.problem);
  twins.reference = bench.posture;
  JointRows path(3, bench.posture.size());
  for (Eigen::Index f = 0; f < 3; ++f) {
    path.row(f) = bench.posture.transpose();
    path(f, 3) += 0.1 * static_cast<double>(f);
  }
  for (std::size_t flip = 0; flip < twins.flips.size(); ++flip) {
    JointRows flipped = path;
    for (Eigen::Index f = 0; f < 3; ++f)
      flipped.row(f) = robot::apply_flip(twins.flips[flip], path.row(f).transpose()).transpose();
    EXPECT_LT((preferred_equivalent(twins, flipped) - path).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(PreferredEquivalent, StaysWithinTheLimits) {
  const TwinBench bench("pa10_dlr_hit2");
  PostureSymmetries twins = find_posture_symmetries(bench.problem);
  const robot::SphericalFlip& shoulder = twins.flips.front();
  twins.reference = robot::apply_flip(shoulder, bench.posture);
  twins.upper[shoulder.middle] = twins.lower[shoulder.middle] = bench.posture[shoulder.middle];
  const JointRows path = bench.posture.transpose().replicate(2, 1);
  EXPECT_EQ(preferred_equivalent(twins, path), path);  // the flip would leave the limits
}

/// A bench whose posture is small, so that every joint has a turn in one direction at least.
TwinBench unwound_ur5e() {
  TwinBench bench("ur5e_shadow");
  bench.posture = 0.1 * (bench.robot.upper + bench.robot.lower);
  return bench;
}

TEST(WholeTurns, OfAllJointsAreUndone) {
  TwinBench bench = unwound_ur5e();
  PostureSymmetries twins = find_posture_symmetries(bench.problem);
  ASSERT_EQ(twins.multi_turn_joints, (std::vector<Eigen::Index>{0, 1, 3, 4, 5}));
  JointRows path(2, bench.posture.size());
  path.row(0) = bench.posture.transpose();
  path.row(1) = bench.posture.transpose().array() + 0.1;
  JointRows wound = path;
  for (const Eigen::Index j : twins.multi_turn_joints)
    wound.col(j).array() += path(1, j) > 0.05 ? -2 * pi : 2 * pi;
  for (const JointVector& reference : {JointVector(), bench.posture}) {
    twins.reference = reference;
    EXPECT_LT((preferred_equivalent(twins, wound) - path).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(WholeTurns, AreNearestToTheReferenceUnlessThatWindsUp) {
  TwinBench bench = unwound_ur5e();
  PostureSymmetries twins = find_posture_symmetries(bench.problem);
  twins.reference = bench.posture;
  JointRows path = bench.posture.transpose();
  path(0, 5) = -3;
  twins.reference[5] = 3;  // 3.28 is nearer to it than -3, and hardly farther from zero
  EXPECT_NEAR(turned_towards_reference(twins, path)(0, 5), 2 * pi - 3, 1e-9);
  path(0, 5) = -2;  // 4.28 is nearer to it, but wound up
  EXPECT_NEAR(turned_towards_reference(twins, path)(0, 5), -2, 1e-9);
  twins.reference[5] = 6;  // asks for a joint that is wound up
  EXPECT_NEAR(turned_towards_reference(twins, path)(0, 5), 2 * pi - 2, 1e-9);
}

TEST(WholeTurns, LeadAwayFromALimit) {
  TwinBench bench = unwound_ur5e();
  const PostureSymmetries twins = find_posture_symmetries(bench.problem);
  JointVector q = bench.posture;
  q[5] = 6;
  JointRows path = q.transpose().replicate(2, 1);
  path(1, 5) = bench.robot.upper[5];
  path(1, 0) = bench.robot.upper[0];
  path(1, 2) = bench.robot.upper[2];  // its range is a whole turn
  const JointVector turned = turned_off_limits(twins, path, q);
  EXPECT_NEAR(turned[5], 6 - 2 * pi, 1e-9);
  EXPECT_NEAR(turned[0], q[0] - 2 * pi, 1e-9);
  EXPECT_EQ(turned[2], q[2]);
}

TEST(PalmSymmetries, AreFoundWhereLinksBetweenCount) {
  TwinBench bench("pa10_dlr_hit2");
  bench.problem.objective.get<humanlike::NaturalPosture>().weight = 1;
  bench.problem.objective.get<humanlike::NaturalPosture>().joints.push_back({1, -1, 0.1, {}});
  EXPECT_LT(find_posture_symmetries(bench.problem).flips.size(), 3u);
  EXPECT_EQ(find_palm_symmetries(bench.problem).flips.size(), 3u);
}

TEST(PalmSymmetries, AreFoundWhereADescriptionRoundsItsAngles) {
  const TwinBench rm75("rm75_inspire");  // 1.5708 for π/2
  EXPECT_TRUE(find_posture_symmetries(rm75.problem).flips.empty());
  EXPECT_EQ(find_palm_symmetries(rm75.problem).flips.size(), 3u);
  const TwinBench xarm7("xarm7_leap");  // elbow and wrist are offset by 53 to 76 mm
  EXPECT_EQ(find_palm_symmetries(xarm7.problem).flips.size(), 1u);
}

TEST(Twins, NoneWhereJointAnglesThemselvesCount) {
  TwinBench bench("pa10_dlr_hit2");
  for (Eigen::Index j = 0; j < 7; ++j) {
    bench.problem.objective.get<humanlike::NaturalPosture>().weight = 1;
    bench.problem.objective.get<humanlike::NaturalPosture>().joints.push_back(
        {static_cast<int>(j), -1, 0.1, {}});
  }
  EXPECT_TRUE(find_posture_symmetries(bench.problem).flips.empty());
}

}  // namespace
}  // namespace morphe::map
