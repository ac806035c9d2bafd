#include "pipeline/study/hand_baselines.hpp"

#include <gtest/gtest.h>

#include "core/collision/fcl_engine.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/study/hand_scores.hpp"
#include "tests/support/finite_differences.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::study {
namespace {

class HandPeers : public testing::Test {
 protected:
  HandPeers() : robot(robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/dlr_hit2.yaml").table) {}

  /// Tips at q about the palm, in its axes.
  std::vector<Vec3> tips_at(const JointVector& q) const {
    std::vector<Pose> poses;
    robot::forward_kinematics(robot, q, poses);
    const Pose palm_from_base = poses[static_cast<std::size_t>(robot.palm_frame)].inverse();
    std::vector<Vec3> tips;
    for (std::size_t i = 0; i < robot.tips.size(); ++i) {
      tips.push_back(palm_from_base * robot::tip_pose(robot, poses, i).translation());
    }
    return tips;
  }

  robot::Robot robot;
};

TEST_F(HandPeers, GradientsAreThoseOfTheirValues) {
  std::mt19937_64 random(5);
  for (const BaselineMethod method : {BaselineMethod::vector, BaselineMethod::dexpilot}) {
    for (int k = 0; k < 10; ++k) {
      const JointVector q = random_position(robot, random), last = random_position(robot, random);
      std::vector<Vec3> human = tips_at(random_position(robot, random));
      human[1] = human[0] + Vec3(0.01, 0.02, 0);  // closed
      ClosedPairs closed;
      update_closed_pairs(human, closed);
      const BaselineHand hand{robot, robot.palm_frame, 1.2};
      JointVector gradient;
      baseline_objective(method, hand, human, closed, last, q, &gradient);
      const JointVector numeric = numeric_gradient(
          [&](const JointVector& at) {
            return baseline_objective(method, hand, human, closed, last, at, nullptr);
          },
          q);
      const double scale = std::max(1.0, numeric.cwiseAbs().maxCoeff());
      EXPECT_LT((gradient - numeric).cwiseAbs().maxCoeff(), 1e-6 * scale);
    }
  }
}

TEST_F(HandPeers, PairsCloseBelowThreeCentimetresAndOpenAboveFive) {
  ClosedPairs closed;
  std::vector<Vec3> human = {{0, 0, 0}, {0.04, 0, 0}, {0.2, 0, 0}};
  const auto thumb_index_at = [&](double x) {
    human[1].x() = x;
    update_closed_pairs(human, closed);
    return closed.closed.front();
  };
  EXPECT_FALSE(thumb_index_at(0.04));
  EXPECT_TRUE(thumb_index_at(0.029));
  EXPECT_TRUE(thumb_index_at(0.049));
  EXPECT_FALSE(thumb_index_at(0.051));
  EXPECT_FALSE(thumb_index_at(0.031));
}

/// A human whose tips are the robot's own: there is nothing to miss, and the scores say so.
TEST_F(HandPeers, FollowARobotLikeHuman) {
  const JointVector middle = 0.5 * (robot.lower + robot.upper);
  HandPath course;
  for (int f = 0; f < 60; ++f) {
    const double u = 0.5 - 0.5 * std::cos(0.1 * f);
    course.time.push_back(0.01 * f);
    course.human.push_back(tips_at(middle + 0.4 * u * (robot.upper - middle)));
  }
  course.goals = course.human;
  course.q = baseline_path(BaselineMethod::vector, {robot, robot.palm_frame, 1}, course.human);
  const HandScores scores = score_hand(robot, course, 0.2);
  EXPECT_LT(scores.tip_mean_m, 0.003);
  EXPECT_GT(scores.correlation, 0.99);
  EXPECT_GT(scores.pinches, 0u);
  EXPECT_LT(scores.max_step_rad, 0.1);
  // Second differences of the same tips are their own.
  HandPath same = course;
  for (std::size_t f = 0; f < same.time.size(); ++f) {
    same.goals[f] = tips_at(same.q.row(static_cast<Eigen::Index>(f)).transpose());
  }
  EXPECT_NEAR(score_hand(robot, same, 0.2).acceleration, 1, 1e-9);
  EXPECT_NEAR(score_hand(robot, same, 0.2).tip_mean_m, 0, 1e-12);
}

/// FCL is asked the same of the same capsules.
TEST_F(HandPeers, OverlapsAreThoseThatFclFinds) {
  std::mt19937_64 random(7);
  HandPath course;
  course.q.resize(200, static_cast<Eigen::Index>(robot.joints()));
  const Scene nothing;
  Tolerances touching;
  touching.required_clearance = 0;
  const collision::CollisionWorld world = collision::make_world(robot, nothing, {}, touching);
  collision::FclEngine fcl(world);
  collision::CollisionScratch scratch;
  int overlapping = 0;
  for (int f = 0; f < 200; ++f) {
    const JointVector q = random_position(robot, random);
    course.q.row(f) = q.transpose();
    course.time.push_back(0.01 * f);
    course.human.push_back(tips_at(q));
    overlapping += fcl.is_free(q, 0, scratch) ? 0 : 1;
  }
  course.goals = course.human;
  const HandScores scores = score_hand(robot, course, 0.04);
  EXPECT_GT(overlapping, 0);
  EXPECT_LT(overlapping, 200);
  EXPECT_DOUBLE_EQ(scores.overlap_share, overlapping / 200.0);
  EXPECT_GT(scores.max_overlap_m, 0);
}

}  // namespace
}  // namespace morphe::study
