#include "stages/verify/carried_object.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "planar_plan.hpp"
#include "random_points.hpp"
#include "stages/verify/separation.hpp"
#include "stages/verify/verify.hpp"
#include "tests/support/projected_distance.hpp"
#include "tests/support/two_link_arm.hpp"

namespace morphe::verify {
namespace {

SceneObject body(const std::string& name, Shape shape, std::vector<double> size,
                 const Vec3& position) {
  SceneObject made;
  made.name = name;
  made.shape = shape;
  made.size = std::move(size);
  made.time = {0};
  made.position = {position};
  made.orientation = {Quat::Identity()};
  return made;
}

/// A cup of 0.1 m on a table whose top is at 0, taken at 1 s, lifted by 0.2 m until 2 s, carried
/// along x until 3 s, and put down at 4 s, as it was recorded. The robot is at rest.
struct Lifted {
  RobotModel robot = two_link_arm();
  Plan plan;

  explicit Lifted(double taken_m, double put_down_m) {
    SceneObject cup = body("cup", Shape::cylinder, {0.03, 0.1}, Vec3(0, 0, 0.05 + taken_m));
    cup.time = {1, 1.5, 2, 3, 4};
    for (const auto& [x, z] : {std::pair(0.0, 0.1), {0.0, 0.2}, {0.5, 0.2}, {0.5, put_down_m}})
      cup.position.push_back(Vec3(x, 0, 0.05 + z));
    cup.orientation.assign(5, Quat::Identity());
    cup.attach_s = 1;
    cup.release_s = 4;
    plan.scene.objects = {cup, body("table", Shape::box, {2, 1, 0.1}, Vec3(0, 0, -0.05))};
    plan.movement.target = "cup";
    plan.movement.phases = {{PhaseKind::grasp, 0.5, 1, 1}, {PhaseKind::transport, 1, 4, 1}};
    Trajectory& trajectory = plan.trajectory;
    for (int k = 0; k <= 10; ++k) trajectory.time.push_back(0.5 * k);
    trajectory.demonstration_time = trajectory.time;
    trajectory.position = trajectory.velocity = trajectory.acceleration = JointRows::Zero(11, 2);
    trajectory.phase.assign(11, PhaseKind::rest);
    trajectory.origin.assign(11, SampleOrigin::mapped);
    trajectory.clearance.assign(11, kUnknown);
  }

  CarriedClearance clearance;
  /// Returns the causes and subjects of the violations.
  std::vector<std::string> violations() {
    std::vector<Mesh> meshes;
    for (const SceneObject& object : plan.scene.objects)
      meshes.push_back(object.shape == Shape::mesh ? make_mesh(object) : Mesh());
    ViolationLog log("");
    clearance = verify_carried_object(robot, plan, make_curve(plan.trajectory), meshes, {}, log);
    std::vector<std::string> found;
    for (const Violation& violation : log.finish())
      found.push_back(violation.cause + " " + violation.subject);
    return found;
  }
};

using testing::ElementsAre;
using testing::IsEmpty;

TEST(CarriedObject, TouchesWhatItStandsOnOnlyWhenItIsTakenAndPutDown) {
  Lifted lifted(0, 0);
  EXPECT_THAT(lifted.violations(), IsEmpty());
  EXPECT_EQ(lifted.clearance.at_samples[0], kInfinity);
  EXPECT_EQ(lifted.clearance.at_samples[2], kInfinity);
  EXPECT_NEAR(lifted.clearance.at_samples[4], 0.2, 1e-9);
  EXPECT_EQ(lifted.clearance.at_samples[8], kInfinity);
  // Between 3 s, at 0.2 m, and the table: contact is allowed from the last sample that is clear.
  EXPECT_NEAR(std::ranges::min(lifted.clearance.along_curve), 0.1, 2e-5);
  EXPECT_THAT(Lifted(-0.0019, -0.0019).violations(), IsEmpty());
  EXPECT_THAT(Lifted(0, -0.003).violations(), ElementsAre("object_collision cup/table"));
  EXPECT_THAT(Lifted(-0.003, 0).violations(), ElementsAre("object_collision cup/table"));
  Lifted dipping(0, 0);
  dipping.plan.scene.objects[0].position[2].z() = 0.05;
  EXPECT_THAT(dipping.violations(), ElementsAre("object_collision cup/table"));
}

TEST(CarriedObject, PassesNothingBetweenTheSamples) {
  Lifted lifted(0, 0);
  const SceneObject block = body("block", Shape::box, {0.03, 0.03, 0.03}, Vec3(0.12, 0, 0.25));
  lifted.plan.scene.objects.push_back(block);
  EXPECT_THAT(lifted.violations(), ElementsAre("object_collision cup/block"));
  lifted.plan.scene.objects.back() = box_mesh(block);
  EXPECT_THAT(lifted.violations(), ElementsAre("object_collision cup/block"));
  // Beside the cup's way: radius and half the side leave 2 mm.
  lifted.plan.scene.objects.back().position[0].y() = 0.047;
  EXPECT_THAT(lifted.violations(), IsEmpty());
  EXPECT_NEAR(std::ranges::min(lifted.clearance.along_curve), 0.002, 2e-5);
}

TEST(CarriedObject, IsNotReleasedInTheAir) {
  EXPECT_THAT(Lifted(0, 0.009).violations(), IsEmpty());
  EXPECT_THAT(Lifted(0, 0.011).violations(), ElementsAre("release cup"));
  // It stood on nothing that is known, and a hand may end with it in the air.
  EXPECT_THAT(Lifted(0.003, 0.011).violations(), IsEmpty());
  Lifted held(0, 0.2);
  held.plan.movement.phases.back().kind = PhaseKind::hold;
  EXPECT_THAT(held.violations(), IsEmpty());
}

TEST(CarriedObject, InAFrameOfTheRobotIsFoundInAnObjectsWay) {
  Plan plan = planar::plan();
  const auto cup_at = [](double time_s) {
    const Eigen::Vector3d q = planar::position_at(time_s);
    const double direction = q.sum() + q(2) + 0.1;  // of the distal link
    const Vec3 along(std::cos(direction), std::sin(direction), 0);
    return Vec3(planar::tip_at(q) - 0.03 * along + 0.038 * Vec3::UnitZ().cross(along));
  };
  SceneObject& cup = plan.scene.objects[1];
  cup.position[0] = cup_at(0.5);
  cup.attached_frame = "distal";
  cup.attach_s = 2.4;
  cup.release_s = 2.8;
  plan.movement.phases = {{PhaseKind::reach, 2.0, 2.35, 1}, {PhaseKind::grasp, 2.35, 2.8, 1}};
  // Above the cup at 0.7 s, 1 mm deep; the links are as high as the cup's middle.
  plan.scene.objects.push_back(
      body("bead", Shape::sphere, {0.004}, cup_at(0.7) + Vec3(0, 0, 0.033)));
  std::vector<std::string> subjects;
  for (const Violation& violation : verify_plan(planar::robot(), "reach/000", plan)) {
    if (violation.cause != "object_collision") continue;
    subjects.push_back(violation.subject);
    EXPECT_NEAR(violation.value, -0.001, 1e-4);
    EXPECT_NEAR(violation.time_s, 0.7, 0.02);
  }
  EXPECT_THAT(subjects, ElementsAre("cup/bead"));
}

TEST(BodyDistance, OfConvexBodiesIsThatOfTheirNearestPoints) {
  Random random(7);
  const Mesh none;
  int apart = 0;
  const auto solid = [&](int kind) {
    const std::vector<double> size{0.05 + 0.1 * std::abs(random.point(1).x()),
                                   0.05 + 0.1 * std::abs(random.point(1).y()),
                                   0.05 + 0.1 * std::abs(random.point(1).z())};
    const Shape shapes[] = {Shape::sphere, Shape::box, Shape::cylinder, Shape::capsule};
    const int counts[] = {1, 3, 2, 2};
    return body("", shapes[kind], {size.begin(), size.begin() + counts[kind]}, Vec3::Zero());
  };
  const auto pose = [&] {
    const Vec3 at = random.point(0.3), axis = random.point(1).normalized();
    return make_pose(at, Quat(Eigen::AngleAxisd(3 * random.point(1).x(), axis)));
  };
  for (int k = 0; k < 800; ++k) {
    const SceneObject a = solid(k % 4), b = solid(k / 4 % 4);
    const Pose pose_a = pose(), pose_b = pose();
    const double got = body_distance({a, none, pose_a}, {b, none, pose_b}, kInfinity);
    const double upper_m = projected_distance(a, pose_a, b, pose_b);
    EXPECT_LE(got, upper_m + 1e-9) << k;
    if (upper_m < 1e-4) continue;
    ++apart;
    EXPECT_NEAR(got, upper_m, 1e-4 * upper_m + 1e-7) << k;
  }
  EXPECT_GT(apart, 300);
}

TEST(BodyDistance, ACupInATableIsAsDeepAsItsLowestPoint) {
  const Mesh none;
  const SceneObject cup = body("cup", Shape::cylinder, {0.035, 0.1}, Vec3::Zero());
  const SceneObject table = body("table", Shape::box, {1, 0.8, 0.04}, Vec3::Zero());
  const SceneObject mesh = box_mesh(table);
  const Mesh made = make_mesh(mesh);
  const Pose table_pose = make_pose(Vec3(0.1, 0, -0.02), Quat::Identity());
  for (const double tilt : {0.0, kRadPerDegree}) {
    const Vec3 at(0.2, 0.1, 0.05 * std::cos(tilt) + 0.035 * std::sin(tilt) - 0.0013);
    const Pose cup_pose = make_pose(at, Quat(Eigen::AngleAxisd(tilt, Vec3::UnitX())));
    EXPECT_NEAR(body_distance({cup, none, cup_pose}, {table, none, table_pose}, 1), -0.0013, 1e-8);
    EXPECT_NEAR(body_distance({cup, none, cup_pose}, {mesh, made, table_pose}, 1), -0.0013, 1e-8);
  }
  // Wholly inside, and clear of all triangles.
  const SceneObject bead = body("bead", Shape::sphere, {0.002}, Vec3::Zero());
  EXPECT_NEAR(body_distance({bead, none, table_pose}, {mesh, made, table_pose}, 1), -0.02, 1e-9);
}

}  // namespace
}  // namespace morphe::verify
