#include "pipeline/report/plan_view.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/report/select_display_rows.hpp"
#include "tests/pipeline/report/turning_plan.hpp"

namespace morphe::report {
namespace {

/// From the arm's two capsules at an angle to a ball of 0.1 m at (0, 0.7, 0).
double distance_to_ball(double angle) {
  double least = kInfinity;
  for (const auto& [from, to] : {std::pair{0.05, 0.2}, std::pair{0.35, 0.55}}) {
    const double along = std::clamp(0.7 * std::sin(angle), from, to);
    const Vec3 on_axis(along * std::cos(angle), along * std::sin(angle), 0);
    least = std::min(least, (on_axis - Vec3(0, 0.7, 0)).norm() - 0.1 - 0.03);
  }
  return least;
}

TEST(ShownSamples, AreDenseEnoughAndHoldTheExtremes) {
  const Trajectory t = minimum_jerk();
  const std::vector<int> rows = select_display_rows(arm(), t, 60);
  EXPECT_EQ(rows.front(), 0);
  EXPECT_EQ(rows.back(), kSamples - 1);
  EXPECT_TRUE(std::ranges::is_sorted(rows));
  for (std::size_t i = 0; i + 1 < rows.size(); ++i)
    EXPECT_LE(
        t.time[static_cast<std::size_t>(rows[i + 1])] - t.time[static_cast<std::size_t>(rows[i])],
        1 / 60.0 + 1e-9);
  EXPECT_LT(rows.size(), 150u);
  EXPECT_THAT(rows, testing::IsSupersetOf({kSamples / 2, 123}));  // greatest speed, least clearance
  // 60 * angle / T^3 at both ends, acceleration 10 / sqrt(3) * angle / T^2 at (1 ± 1/sqrt(3)) / 2.
  const int fastest = static_cast<int>(std::lround((1 - 1 / std::sqrt(3)) / 2 * (kSamples - 1)));
  EXPECT_THAT(
      rows, testing::AnyOf(testing::Contains(fastest), testing::Contains(kSamples - 1 - fastest)));
}

TEST(ShownSamples, SparseOnesAreAllShown) {
  Trajectory t = certify::sweep(0.5);
  EXPECT_THAT(select_display_rows(arm(), t, 60), testing::ElementsAre(0, 1));
  EXPECT_THAT(select_display_rows(arm(), Trajectory{}, 60), testing::IsEmpty());
}

TEST(JerkShares, OfMinimumJerk) {
  const JointRows shares = jerk_ratios(arm(), minimum_jerk());
  const double greatest = 60 * kAngle / std::pow(kDuration_s, 3);
  EXPECT_NEAR(shares.cwiseAbs().maxCoeff(), greatest / 60, 1e-6);
  EXPECT_NEAR(shares(kSamples / 2, 0), -greatest / 2 / 60, 1e-4);
}

TEST(ViewOf, ErrorsSpeedAndClearanceAreTheClosedForms) {
  Plan plan = turning_plan();
  plan.scene.objects = {ball({0, 0.7, 0}, 0.1)};
  const PlanView view = make_plan_view(arm(), std::nullopt, plan);
  ASSERT_EQ(view.motions.size(), 1u);
  const DisplayMotion& motion = view.motions[0];
  EXPECT_EQ(motion.name, "trajectory");
  const double radius = std::hypot(0.55, 0.04);
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const double angle = motion.position(row, 0);
    const double chord = 2 * radius * std::sin(angle / 2);
    EXPECT_NEAR(motion.tip_error(row, 0), std::hypot(chord, 0.003), 1e-12);
    EXPECT_NEAR(motion.mean_tip_speed[k], radius * std::abs(motion.velocity(row, 0)), 1e-12);
    EXPECT_NEAR(
        motion.humanlikeness[k],
        (Vec3(0.3 * std::cos(angle), 0.3 * std::sin(angle), 0) - Vec3(0.3, 0, 0.1)).squaredNorm(),
        1e-12);
    EXPECT_NEAR(motion.nearest[k].separation.distance, distance_to_ball(angle), 1e-9);
    EXPECT_NEAR(motion.arm_error(row, 0), std::acos(3 * std::cos(angle) / std::sqrt(10.0)), 1e-12);
  }
  EXPECT_TRUE(motion.arm_error.rightCols(3).array().isNaN().all());  // no wrist, no palm
  EXPECT_TRUE(motion.touching_pairs.empty());
  EXPECT_EQ(motion.clearance.size(), motion.time.size());
}

TEST(ViewOf, TheWorldBeginsAtThePersonsShoulder) {
  const Plan plan = turning_plan();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).matrix();
  const PlanView view = make_plan_view(arm(), turn, plan);
  EXPECT_TRUE(view.upright);
  EXPECT_NEAR((view.world_from_base * Vec3(0, -1, 0)).norm(), 0, 1e-12);
  EXPECT_TRUE(view.world_from_base.linear().isApprox(turn));
  EXPECT_FALSE(make_plan_view(arm(), std::nullopt, plan).upright);
}

/// The same motion as a path that was not timed.
Plan stopped_plan(Reason reason, SampleOrigin origin) {
  Plan plan = turning_plan();
  plan.reason = reason;
  plan.path.position = plan.trajectory.position;
  plan.path.demonstration_time = plan.trajectory.demonstration_time;
  plan.path.origin.assign(kSamples, origin);
  plan.trajectory = {};
  return plan;
}

TEST(ViewOf, AnInfeasiblePlanShowsItsPathAndTheWorstInstant) {
  Plan plan = stopped_plan(Reason::no_path, SampleOrigin::re_solved);
  // Deepest where the arm points at the ball, at the angle 0.4 in the middle of the movement.
  plan.scene.objects = {ball({0.6 * std::cos(0.4), 0.6 * std::sin(0.4), 0}, 0.04)};
  const PlanView view = make_plan_view(arm(), std::nullopt, plan);
  ASSERT_EQ(view.motions.size(), 1u);
  EXPECT_EQ(view.motions[0].name, "path");
  EXPECT_EQ(view.motions[0].time.front(), 0);
  EXPECT_EQ(view.motions[0].velocity.rows(), 0);
  ASSERT_TRUE(view.worst.has_value());
  EXPECT_NEAR(view.worst->demonstration_s, 6, 1e-9);
  EXPECT_EQ(view.worst->sentence, "forearm and ball overlap by 20.00 mm; the minimum is 1.00 mm");
  EXPECT_FALSE(view.motions[0].touching_pairs.empty());
}

TEST(ViewOf, AMissedGoalSaysWhatWouldPass) {
  const Plan plan = stopped_plan(Reason::tracking, SampleOrigin::mapped);
  const PlanView view = make_plan_view(arm(), std::nullopt, plan);
  ASSERT_TRUE(view.worst.has_value());
  EXPECT_NEAR(view.worst->demonstration_s, 7, 1e-9);
  const double error = std::hypot(2 * std::hypot(0.55, 0.04) * std::sin(kAngle / 2), 0.003);
  EXPECT_THAT(view.worst->sentence,
              testing::HasSubstr("the tolerance is 5.00 mm in grasp and hold"));
  EXPECT_THAT(view.advice, testing::Contains(testing::HasSubstr(fmt::format(
                               "{:.1f} mm from its goal at 7.00 s in the grasp", 1e3 * error))));
}

TEST(ViewOf, AMovementWithoutAnythingHasNoMotion) {
  Plan plan;
  plan.reason = Reason::no_movement;
  const PlanView view = make_plan_view(arm(), std::nullopt, plan);
  EXPECT_TRUE(view.motions.empty());
  EXPECT_FALSE(view.worst.has_value());
  ASSERT_EQ(view.advice.size(), 2u);
  EXPECT_THAT(view.advice[0], testing::HasSubstr("morphe inspect"));
  EXPECT_THAT(view.advice[1], testing::HasSubstr("--set segment.whole_recording=true"));
}

}  // namespace
}  // namespace morphe::report
