#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "stages/import/import.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::planning {
namespace {

const Eigen::DiagonalMatrix<double, 3> kMirror(1, -1, 1);

Pose seen_in_mirror(const Pose& pose) {
  Pose other = Pose::Identity();
  other.linear() = kMirror * pose.linear() * kMirror;
  other.translation() = kMirror * pose.translation();
  return other;
}

/// The robot that takes the mirrored posture at the same angles: y of every frame is turned round.
robot::Robot mirrored(const robot::Robot& robot) {
  RobotModel table = robot;
  table.side = table.side == Side::right ? Side::left : Side::right;
  for (RobotModel::Frame& frame : table.frames) {
    frame.transform = seen_in_mirror(frame.transform);
    frame.axis = frame.prismatic ? Vec3(kMirror * frame.axis) : Vec3(-(kMirror * frame.axis));
  }
  for (RobotModel::Tip& tip : table.tips) tip.transform = seen_in_mirror(tip.transform);
  for (RobotModel::Capsule& capsule : table.capsules) {
    capsule.from = kMirror * capsule.from;
    capsule.to = kMirror * capsule.to;
  }
  return robot::Robot(table);
}

/// Of world_from_base = R: X R Y with the world's mirror X = diag(-1, 1, 1), that is, Rz(pi) Y R Y.
map::PlacementOptions mirrored(map::PlacementOptions placement) {
  for (auto& turn : placement.rotation) {
    if (turn.axis != "y") turn.angle = -turn.angle;
  }
  placement.rotation.insert(placement.rotation.begin(), {"z", M_PI});
  placement.shoulder_offset.x() *= -1;
  return placement;
}

Demonstration shipped(const char* name) {
  Demonstration wanted;
  imports::ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl/recordings.yaml"};
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    if (demonstration.name == name) wanted = std::move(demonstration);
  });
  return wanted;
}

/// Two robots that are each other's mirror image, on one recording: what the one does is the
/// other's in the mirror, up to what rounding makes of a search.
TEST(LeftRobot, DoesAsItsMirrorImageDoes) {
  const LoadedConfig config = load_config(std::filesystem::path(MORPHE_SOURCE_DIR) /
                                          "configs/pipelines/pa10_dlr_hit2.yaml");
  PipelineConfig left_options = config.options;
  left_options.placement = mirrored(left_options.placement);
  const robot::Robot left_robot = mirrored(config.robot);
  const Demonstration recorded = shipped("ADL001DR2");
  ASSERT_FALSE(recorded.name.empty());
  const auto right = plan_demonstration({config.options, config.robot}, recorded);
  const auto left = plan_demonstration({left_options, left_robot}, recorded);
  ASSERT_EQ(left.plans.size(), right.plans.size());
  ASSERT_FALSE(right.plans.empty());
  for (std::size_t k = 0; k < right.plans.size(); ++k) {
    const Plan &a = right.plans[k], &b = left.plans[k];
    ASSERT_EQ(a.reason, Reason::none) << a.detail;
    ASSERT_EQ(b.reason, Reason::none) << b.detail;
    for (std::size_t f = 0; f < a.goals.frames(); ++f) {
      for (std::size_t tip = 0; tip < config.robot.tips.size(); ++tip) {
        const Vec3 goal = a.goals.tip_position(f, tip);
        if (!is_known(goal)) continue;
        ASSERT_LT((b.goals.tip_position(f, tip) - kMirror * goal).norm(), 1e-9);
        const Quat turned = a.goals.tip_orientation(f, tip);
        if (!is_known(turned)) continue;
        ASSERT_LT(angle_between(b.goals.tip_orientation(f, tip),
                                Quat(kMirror * turned.toRotationMatrix() * kMirror)),
                  1e-6);
      }
    }
    ASSERT_EQ(a.scene.objects.size(), b.scene.objects.size());
    for (std::size_t o = 0; o < a.scene.objects.size(); ++o) {
      EXPECT_LT((b.scene.objects[o].position[0] - kMirror * a.scene.objects[o].position[0]).norm(),
                1e-9);
    }
    EXPECT_NEAR(b.certificate.upper_arm_error_mean, a.certificate.upper_arm_error_mean, 0.01);
    EXPECT_NEAR(b.certificate.tip_error_max, a.certificate.tip_error_max, 1e-3);
    EXPECT_NEAR(b.certificate.duration_ratio, a.certificate.duration_ratio, 0.1);
    // Rounding may end a search in another basin: the two fingertips that were seen leave the hand
    // a turn. What it is worth is the same.
    const auto objective = [](const Plan& plan) {
      return std::accumulate(plan.mapped.objective.begin(), plan.mapped.objective.end(), 0.0);
    };
    EXPECT_NEAR(objective(b) / objective(a), 1, 0.01);
  }
}

TEST(LeftRobot, TakesALeftHandAsItIs) {
  // The same recording, held to be that of a left hand: of a right-handed body seen in a mirror.
  // Nothing is mirrored twice over: goals of the left robot are where the recording has them.
  const LoadedConfig config = load_config(std::filesystem::path(MORPHE_SOURCE_DIR) /
                                          "configs/pipelines/pa10_dlr_hit2.yaml");
  const Demonstration right = shipped("ADL001DR2");
  const Demonstration left = reconstruct::mirror_image(right);  // says "right": what it is not
  Demonstration as_left = left;
  as_left.hand = Side::left;
  const robot::Robot left_robot = mirrored(config.robot);
  const Reconstruction from_right = reconstruct_demonstration({config.options, left_robot}, right);
  const Reconstruction from_left = reconstruct_demonstration({config.options, left_robot}, as_left);
  const Reconstruction plain = reconstruct_demonstration({config.options, config.robot}, right);
  ASSERT_EQ(from_left.motion.time.size(), plain.motion.time.size());
  for (std::size_t i = 0; i < plain.motion.time.size(); i += 10) {
    const Vec3 here = plain.motion.tip(i, kIndex);
    if (!is_known(here)) continue;
    const Vec3 mirrored_here(-here.x(), here.y(), here.z());
    EXPECT_LT((from_left.motion.tip(i, kIndex) - mirrored_here).norm(), 1e-12);
    EXPECT_LT((from_right.motion.tip(i, kIndex) - mirrored_here).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace morphe::planning
