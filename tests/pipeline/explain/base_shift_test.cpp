#include "pipeline/explain/base_shift.hpp"

#include <gtest/gtest.h>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/check/check_path.hpp"

namespace morphe::explain {
namespace {

using Eigen::Index;

/// The reference robot, its arm stretched out from its base; the goals of two fingertips are
/// `beyond_m` farther along the arm than they reach.
Plan stretched_plan(const robot::Robot& robot, double beyond_m) {
  constexpr std::size_t kFrames = 11;
  const JointVector posture = JointVector::Zero(static_cast<Index>(robot.joints()))
                                  .cwiseMax(robot.lower)
                                  .cwiseMin(robot.upper);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, posture, poses);
  Plan plan;
  plan.reason = Reason::unreachable;
  plan.movement.end_s = 0.5;
  Goals& goals = plan.goals;
  goals.tip_position = {kFrames, robot.tips.size(), unknown_point()};
  goals.tip_orientation = {kFrames, robot.tips.size(), unknown_rotation()};
  goals.reachable = {kFrames, robot.tips.size(), 0};
  goals.finger_joint_position = {kFrames, kFingerCount, unknown_point()};
  goals.shoulder_position.assign(kFrames, unknown_point());
  goals.elbow_position = goals.wrist_position = goals.shoulder_position;
  goals.wrist_orientation.assign(kFrames, unknown_rotation());
  for (std::size_t f = 0; f < kFrames; ++f) {
    goals.time.push_back(0.05 * static_cast<double>(f));
    for (const std::size_t tip : {0U, 1U}) {
      goals.tip_position(f, tip) =
          robot::tip_pose(robot, poses, tip).translation() + Vec3(0, 0, beyond_m);
    }
  }
  plan.mapped.position = posture.transpose().replicate(static_cast<Index>(kFrames), 1);
  plan.path = {plan.mapped.position, std::vector<SampleOrigin>(kFrames), goals.time};
  return plan;
}

TEST(BaseShift, BringsIntoReachWhatLiesBeyondTheStretchedArm) {
  const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  const planning::PipelineConfig config;  // the base's axes are the world's
  const auto found = find_base_shift(robot, config, stretched_plan(robot, 0.1), 0.16);
  ASSERT_TRUE(found.has_value());
  EXPECT_GT(found->depth_before, 0.1) << "several frames, two tips, 80 mm beyond what is allowed";
  EXPECT_LT(found->depth_after, 0.01 * found->depth_before);
  EXPECT_GT(found->shift.z(), 0.06) << "all but the 20 mm that tracking allows";
  EXPECT_LE(found->shift.cwiseAbs().maxCoeff(), 0.16);
}

TEST(BaseShift, IsNoneWhereNothingIsWrongOrNothingHelps) {
  const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  const planning::PipelineConfig config;
  EXPECT_FALSE(find_base_shift(robot, config, stretched_plan(robot, 0), 0.16));
  EXPECT_FALSE(find_base_shift(robot, config, stretched_plan(robot, 0.9), 0.16));
  EXPECT_FALSE(find_base_shift(robot, config, Plan{}, 0.16));
}

}  // namespace
}  // namespace morphe::explain
