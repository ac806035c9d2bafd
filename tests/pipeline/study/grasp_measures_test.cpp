#include "pipeline/study/grasp_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pipeline/study/grasp_rows.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe::study {
namespace {

TEST(RecordedContacts, AreWhereASphereIsNearestToTheSkin) {
  SceneObject handle;
  handle.shape = Shape::sphere;
  handle.size = {0.02};
  handle.time = {0, 1};
  handle.position = {Vec3(1, 0, 0), Vec3(1, 0, 0.1)};
  handle.orientation.assign(2, Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ())));
  ObservedHand hand;
  hand.tip.fill(unknown_point());
  hand.middle_joint.fill(unknown_point());
  const Vec3 centre(1, 0, 0.05);                    // half-way
  hand.tip[kThumb] = centre + Vec3(0, -0.036, 0);   // skin 5 mm away
  hand.tip[kIndex] = centre + Vec3(0.028, 0, 0);    // 3 mm inside
  hand.tip[kMiddle] = centre + Vec3(0, 0, 0.0415);  // 10.5 mm away
  hand.tip[kRing] = centre + Vec3(0, 0, 0.0205);    // 10.5 mm inside
  const std::vector<KnownContact> contacts = recorded_contacts(handle, 0.5, hand, {});
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[0].finger, kThumb);
  EXPECT_LT((contacts[0].point - Vec3(-0.02, 0, 0)).norm(), 1e-12) << "-y of the world";
  EXPECT_LT((contacts[0].normal - Vec3(1, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(contacts[1].finger, kIndex);
  EXPECT_LT((contacts[1].point - Vec3(0, -0.02, 0)).norm(), 1e-12);
  EXPECT_TRUE(recorded_contacts(handle, kUnknown, hand, {}).empty()) << "no grasp";
}

TEST(InstantOfGrasp, IsTheMiddleOfTheFirst) {
  EXPECT_TRUE(std::isnan(grasp_instant_s({{PhaseKind::reach, 0, 1}})));
  EXPECT_EQ(grasp_instant_s({{PhaseKind::reach, 0, 1},
                             {PhaseKind::grasp, 1, 1.5},
                             {PhaseKind::hold, 1.5, 2},
                             {PhaseKind::grasp, 3, 4}}),
            1.25);
}

TEST(ContactError, IsThatOfPointsAndDirections) {
  KnownContact known;
  known.point = {0.02, 0, 0};
  known.normal = {-1, 0, 0};
  known.tip = {0.031, 0, 0};
  known.middle_joint = {0.031, 0, 0.04};
  RobotFinger finger;
  finger.contact_point = {0, 0.02, 0};
  finger.tip = {0.031, 0.003, 0.004};
  finger.pad = {0.031, 0, -0.012};
  finger.middle_joint = finger.tip + Vec3(0.03, 0, 0.03);
  finger.gap = -0.001;
  finger.pad_angle = 0.3;
  const ContactError error = contact_error(known, finger);
  EXPECT_NEAR(error.distance, 0.02 * std::sqrt(2), 1e-15);
  EXPECT_NEAR(error.precision, 0.005, 1e-15);
  EXPECT_NEAR(error.pad_precision, 0.012, 1e-15);
  EXPECT_NEAR(error.alignment, std::numbers::pi / 4, 1e-15) << "bones, whatever their length";
  EXPECT_EQ(error.gap, -0.001);
  EXPECT_EQ(error.pad_angle, 0.3);
}

/// The second link, 0.5 m along x with a radius of 10 mm, sweeps through a ball of 50 mm.
TEST(DeepestPenetration, TellsPadsFromOtherLinks) {
  RobotModel table = two_link_arm();
  table.capsules.push_back({"upper", 0, Vec3(0.1, 0, 0), Vec3(0.4, 0, 0), 0.01, true});
  table.capsules.push_back({"finger", 1, Vec3(0.1, 0, 0), Vec3(0.4, 0, 0), 0.01, true});
  RobotModel::Tip tip;
  tip.name = "index_tip";
  tip.frame = 1;
  tip.finger = 1;
  tip.transform.translation() = Vec3(0.41, 0, 0);
  table.tips.push_back(tip);
  const robot::Robot robot(table);
  ASSERT_EQ(robot.pads[0].capsule, 1);
  Plan plan;
  SceneObject ball;
  ball.name = "ball";
  ball.shape = Shape::sphere;
  ball.size = {0.05};
  ball.time = {0};
  ball.position = {Vec3(0.7, 0.057, 0)};
  ball.orientation = {Quat::Identity()};
  plan.scene.objects.push_back(ball);
  plan.movement.target = "ball";
  Trajectory trajectory;
  trajectory.time = trajectory.demonstration_time = {0, 1};
  trajectory.position = JointRows::Zero(2, 2);
  trajectory.position(1, 1) = -0.5;
  const auto deepest = [&](const Trajectory& of) {
    const collision::CollisionWorld world =
        collision::make_world(robot, plan.scene, plan.movement, {});
    return deepest_penetration(world, of);
  };
  EXPECT_NEAR(deepest(trajectory).pads_m, 0.003, 1e-9) << "stretched it is 57 mm from the centre";
  EXPECT_EQ(deepest(trajectory).other_links_m, 0);
  plan.scene.objects[0].position = {Vec3(0.3, -0.055, 0)};
  EXPECT_NEAR(deepest(trajectory).other_links_m, 0.005, 1e-9);
  EXPECT_EQ(deepest(trajectory).pads_m, 0);
  plan.movement.target = "";
  EXPECT_EQ(deepest(trajectory).other_links_m, 0) << "nothing is grasped";
}

TEST(TipOfFinger, LeavesOutTipsBetweenFingers) {
  RobotModel table;
  for (const auto& [finger, along] :
       {std::pair(0, kUnknown), std::pair(1, 0.0), std::pair(2, 0.5), std::pair(4, 1.0)}) {
    RobotModel::Tip tip;
    tip.finger = finger;
    tip.finger_curve_share = along;
    table.tips.push_back(tip);
  }
  EXPECT_EQ(tip_of_finger(table, 0), 0U);
  EXPECT_EQ(tip_of_finger(table, 1), 1U);
  EXPECT_FALSE(tip_of_finger(table, 2));
  EXPECT_FALSE(tip_of_finger(table, 3));
  EXPECT_EQ(tip_of_finger(table, 4), 3U);
}

TEST(GraspRows, CompareWhatIsExecutableBothWays) {
  std::vector<GraspComparison> pairs(4);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    GraspScore &contacts = pairs[k].contacts, &fingertips = pairs[k].fingertips;
    contacts.has_trajectory = contacts.executable = k > 0;
    fingertips.has_trajectory = fingertips.executable = k < 3;
    contacts.humanlikeness = fingertips.humanlikeness = 2;
    contacts.duration_s = 1.5 + static_cast<double>(k);  // 2.5 and 3.5 over 2
    fingertips.duration_s = 2;
    contacts.penetration.pads_m = 0.0004 * static_cast<double>(k);
    pairs[k].demonstrated_contacts = 3;
    contacts.demonstrated = contacts.touching = static_cast<int>(k);
    ContactError error;
    error.distance = 0.001 * static_cast<double>(k);
    if (contacts.has_trajectory) contacts.errors = {error};
  }
  GraspStudyOptions options;
  options.contacts.name = "contacts";
  options.fingertips.name = "fingertips";
  StudyResult result;
  add_grasp_rows(options, {{"set", "one"}}, pairs, result);
  const auto row = [&](const std::string& variant, const std::string& metric) {
    for (const StudyRow& one : result.rows) {
      if (one.case_values.back().second == variant && one.metric == metric) return one;
    }
    ADD_FAILURE() << "no row " << metric;
    return StudyRow{};
  };
  EXPECT_EQ(row("contacts", "executable").ours, 0.75);
  EXPECT_EQ(row("contacts", "executable").at_least, 0.75);
  const StudyRow distance = row("contacts", "contact point error, median");
  EXPECT_NEAR(distance.ours, 2, 1e-12);
  EXPECT_EQ(distance.count, 3U);
  EXPECT_EQ(distance.at_most, 5);
  const StudyRow pads = row("contacts", "penetration of pads, largest");
  EXPECT_NEAR(pads.ours, 1.2, 1e-12);
  EXPECT_FALSE(pads.meets_requirement()) << "a millimetre at most";
  const StudyRow duration = row("contacts over fingertips", "duration, ratio, 90 %");
  EXPECT_EQ(duration.count, 2U);
  EXPECT_EQ(duration.ours, 1.75);
  EXPECT_EQ(row("contacts over fingertips", "duration, ratio, median").ours, 1.25);
  EXPECT_EQ(row("contacts", "known contacts").ours, 3) << "one each of those that run";
  EXPECT_EQ(row("contacts", "contacts demonstrated").ours, 9);
  EXPECT_EQ(row("contacts", "contacts dropped").ours, 3);
  EXPECT_EQ(row("contacts", "contacts touching").ours, 6);
}

}  // namespace
}  // namespace morphe::study
