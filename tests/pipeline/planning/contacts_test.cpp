#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/collision/world.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "tests/pipeline/planning/shipped_reach.hpp"

namespace morphe::planning {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

Plan planned_drink(const std::vector<std::string>& settings) {
  const LoadedConfig loaded = load_config(
      std::filesystem::path(MORPHE_SOURCE_DIR) / "configs/pipelines/pa10_dlr_hit2.yaml", settings);
  const PlanningInputs planner{loaded.options, loaded.robot};
  return plan_demonstration(planner, shipped_reach("ADL001DR2", imports::ForwardSource::body))
      .plans.at(0);
}

TEST(Contacts, PadsTouchTheCupAndAnotherFingerCloses) {
  const Plan plan = planned_drink({"grasp.close_fingers=true"});
  ASSERT_TRUE(plan.executable()) << plan.detail;
  EXPECT_EQ(plan.tolerances.max_penetration, 0.001);
  EXPECT_EQ(plan.tolerances.max_link_penetration, 0.0);
  ASSERT_GE(plan.grasp.contacts.size(), 3U);
  const SceneObject& cup = *find_object(plan.scene.objects, plan.movement.target);
  for (const PadContact& contact : plan.grasp.contacts) {
    EXPECT_GT(contact.signed_distance, -0.001) << contact.tip;
    EXPECT_LT(contact.signed_distance, 0.0005) << contact.tip;
    EXPECT_LT((contact.point - contact.desired_point).norm(), 0.005) << contact.tip;
    EXPECT_NEAR(contact.point.head<2>().norm(), cup.size[0], 1e-6) << "on the cup's side";
    EXPECT_LT((contact.normal + contact.point.cwiseProduct(Vec3(1, 1, 0)).normalized()).norm(),
              1e-6)
        << "inwards";
    EXPECT_LT(contact.pad_angle, 30 * kRadPerDegree) << contact.tip << " faces the surface";
  }
  EXPECT_THAT(plan.grasp.contacts[2].tip, AnyOf("middle_tip", "ring_tip")) << "seen by no marker";
  EXPECT_EQ(plan.grasp.contacts[2].origin, ContactOrigin::auto_closed);
  EXPECT_THAT(plan.detail, HasSubstr("little_tip stays open"));
}

TEST(Contacts, TheSqueezeBalancesInsideTheConesAndTorquesAreItsForces) {
  const Plan plan = planned_drink({"grasp.friction_coefficient=0.7"});
  ASSERT_TRUE(plan.executable()) << plan.detail;
  const GraspQuality& quality = plan.grasp.quality;
  EXPECT_EQ(quality.friction_coefficient, 0.7);
  EXPECT_LE(quality.epsilon_lower, quality.epsilon_upper);
  EXPECT_GT(quality.epsilon_lower, 0) << "three soft fingers";
  EXPECT_GT(quality.required_force_worst, quality.required_force_gravity);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double largest = 0;
  for (const PadContact& contact : plan.grasp.contacts) {
    const Vec3 whole = contact.normal_force * contact.normal + contact.friction_force;
    force += whole;
    torque += contact.point.cross(whole);
    largest = std::max(largest, contact.normal_force);
    EXPECT_LE(contact.friction_force.norm(), 0.7 * contact.normal_force + 1e-9);
    EXPECT_NEAR(contact.friction_force.dot(contact.normal), 0, 1e-9);
  }
  EXPECT_GT(largest, 1);
  for (const PadContact& contact : plan.grasp.contacts) {
    EXPECT_GE(contact.normal_force, 0.09 * largest) << contact.tip << " bears its share";
  }
  EXPECT_LT(force.norm(), 1e-3 * largest);
  EXPECT_LT(torque.norm(), largest * (3 * quality.torsional_friction)) << "the rest is torsion";
  EXPECT_LE(plan.grasp.grasp_torque.cwiseAbs().maxCoeff(), 1 + 1e-6);
  EXPECT_EQ(plan.grasp.grasp_torque.head(7).norm(), 0) << "the arm holds the hand";
  const JointVector beyond = plan.grasp.servo_target - plan.grasp.grasp_posture;
  EXPECT_LT((10 * beyond - plan.grasp.grasp_torque).norm(), 1e-9);
}

TEST(Contacts, ThatCannotHoldHaveNoSqueezeAndThePlanSaysSo) {
  const Plan plan = planned_drink({"grasp.friction_coefficient=0.01"});
  ASSERT_TRUE(plan.executable()) << plan.detail;
  EXPECT_LT(plan.grasp.quality.epsilon_upper, 0) << "ice";
  EXPECT_EQ(plan.grasp.grasp_torque.size(), 0);
  EXPECT_TRUE(std::isnan(plan.grasp.contacts.at(0).normal_force));
  EXPECT_THAT(plan.detail, HasSubstr("no squeeze: no forces at these contacts are in balance"));
}

TEST(Contacts, AreOnlyThereWhereTheConfigAsksForThem) {
  const Plan plan = planned_drink({});
  EXPECT_EQ(plan.tolerances.max_penetration, 0.005);
  EXPECT_FALSE(plan.tolerances.max_link_penetration);
  EXPECT_EQ(plan.goals.tip_to_pad_share.rows, 0U);
  EXPECT_TRUE(plan.grasp.contacts.empty());
}

/// Returns the largest gap between a pad that touches at the grasp and the target in the palm, over
/// the samples in which it is carried, with poses computed here [m].
double widest_gap_while_carried(const Plan& plan) {
  const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  const SceneObject& cup = *find_object(plan.scene.objects, plan.movement.target);
  double widest = -kInfinity;
  std::optional<Pose> palm_from_cup;
  std::vector<Pose> base_from_frame;
  for (std::size_t i = 0; i < plan.trajectory.samples(); ++i) {
    const double time_s = plan.trajectory.demonstration_time[i];
    if (time_s < cup.attach_s || time_s > cup.release_s) continue;
    const JointVector q = plan.trajectory.position.row(static_cast<Eigen::Index>(i)).transpose();
    robot::forward_kinematics(robot, q, base_from_frame);
    const Pose& base_from_palm = base_from_frame[static_cast<std::size_t>(robot.palm_frame)];
    if (!palm_from_cup) palm_from_cup = base_from_palm.inverse() * recorded_pose(cup, time_s);
    const Pose cup_from_base = (base_from_palm * *palm_from_cup).inverse();
    for (const PadContact& contact : plan.grasp.contacts) {
      if (contact.state != ContactState::touching) continue;
      const auto tip =
          std::ranges::find(robot.tips, contact.tip, &RobotModel::Tip::name) - robot.tips.begin();
      const Vec3 pad = cup_from_base * robot::tracked_point(robot, base_from_frame, tip, 1);
      const double radius = robot.pads[static_cast<std::size_t>(tip)].radius;
      widest = std::max(widest, pad.head<2>().norm() - cup.size[0] - radius);
    }
  }
  return widest;
}

TEST(Contacts, HoldTheCupAsOneBodyToTheMouthAndBack) {
  const Plan plan = planned_drink({"grasp.close_fingers=true", "segment.plan_until=return"});
  ASSERT_TRUE(plan.executable()) << plan.detail;
  const SceneObject& cup = *find_object(plan.scene.objects, plan.movement.target);
  EXPECT_EQ(cup.attached_frame.empty(), false);
  EXPECT_GT(cup.time.size(), 100U) << "the recorded way is the goal";
  EXPECT_LT(plan.certificate.held_drift, 0.0005);
  EXPECT_LT(plan.certificate.held_turn, 1 * kRadPerDegree);
  EXPECT_LT(widest_gap_while_carried(plan), 0.0002 + 0.0005);
}

/// The least room at any sample when pads may sink in by 1 mm, and other links not at all [m].
double least_room(const Plan& plan) {
  const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  Tolerances tolerances = plan.tolerances;
  tolerances.max_penetration = 0.001;
  tolerances.max_link_penetration = 0;
  const collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, tolerances);
  collision::CollisionScratch scratch;
  double least = kInfinity;
  for (std::size_t i = 0; i < plan.trajectory.samples(); ++i) {
    const JointVector q = plan.trajectory.position.row(static_cast<Eigen::Index>(i)).transpose();
    least = std::min(
        least,
        collision::least_slack(world, q, plan.trajectory.demonstration_time[i], scratch).slack());
  }
  return least;
}

TEST(Contacts, WhereNothingTouchesThePlanIsTheOneByTipsAndKeepsOutOfTheTarget) {
  const std::vector<std::string> nobody{"grasp.touch_distance=0.0001", "grasp.pad_depth=0"};
  std::vector<std::string> deeper = nobody;
  deeper.insert(deeper.end(), {"grasp.max_penetration=0.005", "grasp.max_link_penetration=0.005"});
  const Plan by_tips = planned_drink({}), plan = planned_drink(deeper);
  ASSERT_TRUE(plan.executable()) << plan.detail;
  EXPECT_THAT(plan.detail, HasSubstr("no contacts: no fingertip's skin was within"));
  EXPECT_EQ(plan.trajectory.position, by_tips.trajectory.position) << "bit for bit";
  EXPECT_EQ(plan.goals.tip_to_pad_share.rows, 0U);

  // A cup that is wider than the tips are apart.
  const std::string wide = "scene.target.pad_depth=0.008";
  const Plan deep = planned_drink({wide}), out = planned_drink({wide, nobody[0], nobody[1]});
  ASSERT_TRUE(deep.executable() && out.executable()) << deep.detail << out.detail;
  EXPECT_LT(least_room(deep), -1e-4) << "or there is nothing to keep out of";
  EXPECT_GE(least_room(out), -1e-6);
}

}  // namespace
}  // namespace morphe::planning
