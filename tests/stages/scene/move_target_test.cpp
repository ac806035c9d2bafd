#include "stages/scene/move_target.hpp"
#include "stages/scene/build_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/config/fields.hpp"

namespace morphe::scene {
namespace {

constexpr double kStep_s = 0.01;

/// A straight reach of 1 s at constant speed along y, then a grasp of 0.5 s; the hand is turned and
/// its fingers are open all the while.
struct Reach {
  HumanMotion motion;
  Movement movement;
  Scene scene;

  Reach() {
    const std::size_t frames = 201;
    motion.tip = motion.finger_joint = Array2D<Vec3>(frames, kFingerCount, unknown_point());
    motion.tip_orientation = Array2D<Quat>(frames, kFingerCount, unknown_rotation());
    const Quat hand(Eigen::AngleAxisd(0.3, Vec3(0.6, 0, 0.8)));
    for (std::size_t i = 0; i < frames; ++i) {
      const double t = kStep_s * static_cast<double>(i);
      const double share = std::clamp(t - 0.2, 0.0, 1.0);
      const Vec3 wrist(0.1, 0.05 + 0.3 * share, 0.1 + 0.02 * share);
      motion.time.push_back(t);
      motion.shoulder.push_back(Vec3(0, -0.1, 0.35));
      motion.elbow.push_back(Vec3(0.15, -0.05 + 0.1 * share, 0.1));
      motion.wrist.push_back(wrist);
      motion.wrist_orientation.push_back(hand);
      for (const std::size_t finger : {0u, 1u}) {
        motion.tip(i, finger) = wrist + hand * Vec3(0.01, finger == 0 ? 0.05 : -0.05, 0.12);
        motion.tip_orientation(i, finger) = hand;
        motion.finger_joint(i, finger) = wrist + hand * Vec3(0, 0, 0.09);
      }
    }
    motion.arm_angles = JointRows::Zero(static_cast<Eigen::Index>(frames), 7);
    movement.begin_s = 0.2;
    movement.end_s = 1.7;
    movement.phases = {{PhaseKind::reach, 0.2, 1.2, 1}, {PhaseKind::grasp, 1.2, 1.7, 1}};
    scene = build_scene({}, {}, motion, movement);
  }

  RelocatedMovement moved(const SceneOptions& options) const {
    return move_target(options, motion, movement, scene);
  }
};

const SceneObject& cup_of(const Scene& scene) { return scene.objects.back(); }

SceneOptions by(const Vec3& position, const Vec3& rpy) {
  SceneOptions options;
  options.target.pose_offset = {position, rpy};
  return options;
}

Pose hand_at(const HumanMotion& motion, std::size_t i) {
  return make_pose(motion.wrist[i], motion.wrist_orientation[i]);
}

TEST(MoveTarget, TheGraspIsTheSameInTheTargetsFrame) {
  const Reach r;
  const RelocatedMovement m = r.moved(by(Vec3(0.08, -0.05, 0), Vec3(0, 0, 0.6)));
  const Pose before = recorded_pose(cup_of(r.scene), 1.2),
             after = recorded_pose(cup_of(m.scene), 1.2);
  EXPECT_LT((after.translation() - before.translation() - Vec3(0.08, -0.05, 0)).norm(), 1e-12);
  EXPECT_NEAR(angle_between(Quat(before.linear()), Quat(after.linear())), 0.6, 1e-12);
  for (std::size_t i = 120; i <= 170; ++i) {
    EXPECT_TRUE((before.inverse() * hand_at(r.motion, i))
                    .isApprox(after.inverse() * hand_at(m.motion, i), 1e-12));
    for (const std::size_t finger : {0u, 1u}) {
      const auto in = [&](const Pose& cup, const Vec3& point) -> Vec3 {
        return cup.inverse() * point;
      };
      EXPECT_LT((in(before, r.motion.tip(i, finger)) - in(after, m.motion.tip(i, finger))).norm(),
                1e-12);
      EXPECT_LT((in(before, r.motion.finger_joint(i, finger)) -
                 in(after, m.motion.finger_joint(i, finger)))
                    .norm(),
                1e-12);
    }
  }
  EXPECT_EQ(m.motion.arm_angles.rows(), 0);
  EXPECT_EQ(m.motion.estimated, std::vector<std::string>{"transported"});
  ASSERT_EQ(m.motion.reconstruction_notes.size(), 1u);
  EXPECT_THAT(m.motion.reconstruction_notes[0],
              testing::HasSubstr("cup is 94 mm from its recorded position, rotated by 34 degrees"));
}

TEST(MoveTarget, AShiftIsBlendedInByMinimumJerk) {
  const Reach r;
  const Vec3 shift(0.06, 0.02, 0.01);
  const RelocatedMovement m = r.moved(by(shift, Vec3::Zero()));
  for (std::size_t i = 0; i < r.motion.time.size(); ++i) {
    // At constant speed the share of the way is that of the time; 0.3 s is its first quarter …
    const double s = std::clamp(r.motion.time[i] - 0.2, 0.0, 1.0);
    double w = s * s * s * (10 - 15 * s + 6 * s * s);
    if (r.motion.time[i] > r.movement.end_s) w = 0;  // another movement's
    EXPECT_LT((m.motion.wrist[i] - r.motion.wrist[i] - w * shift).norm(), 1e-9) << i;
    EXPECT_LT((m.motion.tip(i, 1) - r.motion.tip(i, 1) - w * shift).norm(), 1e-9);
    EXPECT_EQ(m.motion.shoulder[i], r.motion.shoulder[i]);
  }
}

TEST(MoveTarget, TheHandStaysRigidAndTheArmKeepsItsLengths) {
  const Reach r;
  const RelocatedMovement m = r.moved(by(Vec3(0.05, 0.04, 0), Vec3(0.1, -0.2, 0.8)));
  const auto distance = [](const Vec3& a, const Vec3& b) { return (a - b).norm(); };
  double last = 0;
  for (std::size_t i = 0; i < r.motion.time.size(); ++i) {
    const HumanMotion &from = r.motion, &to = m.motion;
    EXPECT_NEAR(distance(to.tip(i, 0), to.wrist[i]), distance(from.tip(i, 0), from.wrist[i]),
                1e-12);
    EXPECT_NEAR(distance(to.tip(i, 0), to.tip(i, 1)), distance(from.tip(i, 0), from.tip(i, 1)),
                1e-12);
    EXPECT_NEAR(distance(to.elbow[i], to.shoulder[i]), distance(from.elbow[i], from.shoulder[i]),
                1e-12);
    EXPECT_NEAR(distance(to.elbow[i], to.wrist[i]), distance(from.elbow[i], from.wrist[i]), 1e-12);
    EXPECT_LT(distance(to.elbow[i], from.elbow[i]), 0.15);
    // About the cup's old place it goes round by the same angle as the cup, at the same distance.
    const double turned = angle_between(to.wrist_orientation[i], from.wrist_orientation[i]);
    if (r.motion.time[i] <= r.movement.end_s) {
      EXPECT_GE(turned, last - 1e-9);
      last = turned;
    }
  }
}

TEST(MoveTarget, AnAbsolutePlaceIsTheSameAsTheShiftToIt) {
  const Reach r;
  const Vec3 shift(0.03, -0.06, 0);
  SceneOptions placed;
  placed.target.pose = TargetPose{cup_of(r.scene).position[0] + shift, Vec3(0, 0, 0.4)};
  const RelocatedMovement a = r.moved(placed), b = r.moved(by(shift, Vec3(0, 0, 0.4)));
  for (std::size_t i = 0; i < r.motion.time.size(); ++i) {
    EXPECT_TRUE(hand_at(a.motion, i).isApprox(hand_at(b.motion, i), 1e-12));
    EXPECT_LT((a.motion.elbow[i] - b.motion.elbow[i]).norm(), 1e-12);
  }
}

TEST(MoveTarget, ATrackedTargetGoesWithItsWholeTrack) {
  Reach r;
  SceneObject& cup = r.scene.objects.back();
  cup.time = {0, 1.5, 1.9};
  cup.position = {cup.position[0], cup.position[0], cup.position[0] + Vec3(0, 0, 0.2)};
  cup.orientation.assign(3, Quat::Identity());
  const RelocatedMovement m = r.moved(by(Vec3(0.1, 0, 0), Vec3(0, 0, std::numbers::pi / 2)));
  EXPECT_LT((cup_of(m.scene).position[2] - cup.position[2] - Vec3(0.1, 0, 0)).norm(), 1e-12);
}

TEST(MoveTarget, TheTableReachesUnderTheNewPlace) {
  const Reach r;
  const RelocatedMovement m = r.moved(by(Vec3(0.9, 0, 0), Vec3::Zero()));
  const SceneObject& table = m.scene.objects.front();
  ASSERT_EQ(table.name, "table");
  EXPECT_GT(table.position[0].x() + table.size[0] / 2, cup_of(m.scene).position[0].x() + 0.1);
  EXPECT_NEAR(table.position[0].z(), r.scene.objects.front().position[0].z(), 1e-12);
  EXPECT_THAT(m.motion.reconstruction_notes[0], testing::HasSubstr("arm would not reach it in"));
}

TEST(MoveTarget, NothingToMoveChangesNothing) {
  const Reach r;
  const RelocatedMovement m = r.moved({});
  for (std::size_t i = 0; i < r.motion.time.size(); ++i) {
    EXPECT_EQ(m.motion.wrist[i], r.motion.wrist[i]);
    EXPECT_EQ(m.motion.elbow[i], r.motion.elbow[i]);
  }
  EXPECT_EQ(m.motion.arm_angles.rows(), r.motion.arm_angles.rows());
  EXPECT_TRUE(m.motion.reconstruction_notes.empty());

  Reach without;
  without.movement.phases = {{PhaseKind::reach, 0.2, 1.2, 1}};
  const RelocatedMovement none = without.moved(by(Vec3(0.1, 0, 0), Vec3::Zero()));
  EXPECT_EQ(none.motion.wrist[150], without.motion.wrist[150]);
  EXPECT_THAT(none.motion.reconstruction_notes,
              testing::ElementsAre(testing::HasSubstr("no target")));
}

TEST(MoveTarget, IsAskedForOneWayOnly) {
  TargetOptions options;
  options.pose_offset.position = Vec3(0.1, 0, 0);
  EXPECT_EQ(validation_error(options), "");
  options.pose = TargetPose{};
  EXPECT_THAT(validation_error(options), testing::HasSubstr("pose: "));
}

}  // namespace
}  // namespace morphe::scene
