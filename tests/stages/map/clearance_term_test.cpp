#include "stages/map/clearance_term.hpp"

#include <gtest/gtest.h>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/support/finite_differences.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::map {
namespace {

/// The reference robot beside a table top through its workspace.
struct ClearanceBench {
  ClearanceBench()
      : robot(robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table) {
    SceneObject table;
    table.name = "table";
    table.size = {0.8, 0.8, 0.04};
    table.time = {0};
    table.position = {Vec3(0.6, 0, 0.7)};
    table.orientation = {Quat::Identity()};
    scene.objects.push_back(table);
    world = collision::make_world(robot, scene, Movement{}, Tolerances{});
  }
  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
};

TEST(ClearanceTerm, GradientIsThatOfTheValue) {
  const ClearanceBench bench;
  ClearanceTerm term;
  term.activation_distance_m = 0.02;
  ClearanceScratch scratch;
  const auto model_at = [&](const JointVector& q) {
    solve::Quadratic model;
    model.reset(q.size());
    add_clearance(term, bench.world, q, 0, scratch, model);
    return model;
  };
  // Fingers of a half-open hand, a centimetre or less from each other.
  JointVector reaching(static_cast<Eigen::Index>(bench.robot.joints()));
  reaching << 1.2, -1.0, -1.6, 1.6, 2.5, 0.7, 0.5, 0.1, 0.5, 0.4, 0, 0.3, 0.3, 0, 0.4, 0.3, 0, 0.4,
      0.3, 0, 0.4, 0.3;
  const JointVector middle = 0.5 * (bench.robot.lower + bench.robot.upper);
  std::mt19937_64 random(3);
  int compared = 0;
  for (int i = 0; i < 3000 && compared < 40; ++i) {
    const JointVector q = reaching + 0.03 * (random_position(bench.robot, random) - middle);
    const double least = collision::least_slack(bench.world, q, 0, scratch.collision).slack();
    // Deep inside one another, nearest points jump; the term is for what barely touches.
    if (least < -0.004 || least > term.activation_distance_m) continue;
    const solve::Quadratic model = model_at(q);
    const JointVector numeric =
        numeric_gradient([&](const JointVector& at) { return model_at(at).value; }, q, 1e-7);
    EXPECT_LT((model.gradient - numeric).cwiseAbs().maxCoeff(),
              1e-4 * std::max(1.0, numeric.cwiseAbs().maxCoeff()));
    ++compared;
  }
  EXPECT_GE(compared, 20);
}

/// A ball in the palm, beside another one: the gradient is that of the way of what is carried.
TEST(ClearanceTerm, OfWhatIsCarriedHasTheGradientOfItsValue) {
  ClearanceBench bench;
  const JointVector q = 0.5 * (bench.robot.lower + bench.robot.upper);
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(bench.robot, q, base_from_frame);
  const Vec3 palm = base_from_frame[bench.robot.palm_frame].translation();
  const auto ball = [&](const std::string& name, const Vec3& position) {
    SceneObject made;
    made.name = name;
    made.shape = Shape::sphere;
    made.size = {0.01};
    made.time = {0};
    made.position = {position};
    made.orientation = {Quat::Identity()};
    return made;
  };
  // A metre away, so that no link is near; farther apart than what is stood on.
  SceneObject carried = ball("carried", palm + Vec3(0, 0, 1));
  carried.attached_frame = bench.robot.frames[bench.robot.palm_frame].name;
  carried.attach_s = 0;
  bench.scene.objects = {carried, ball("other", palm + Vec3(0.013, 0.013, 1.013))};
  Movement movement;
  movement.target = "carried";
  bench.world = collision::make_world(bench.robot, bench.scene, movement, Tolerances{});
  bench.world.pairs.erase_if([](const auto&) { return true; });
  collision::attach_target({0, 1}, q.transpose().replicate(2, 1), bench.world);
  ClearanceTerm term;
  ClearanceScratch scratch;
  const auto model_at = [&](const JointVector& at) {
    solve::Quadratic model;
    model.reset(at.size());
    add_clearance(term, bench.world, at, 0.5, scratch, model);
    return model;
  };
  EXPECT_GT(model_at(q).value, 0);
  const JointVector numeric =
      numeric_gradient([&](const JointVector& at) { return model_at(at).value; }, q, 1e-7);
  EXPECT_GT(numeric.cwiseAbs().maxCoeff(), 1);
  EXPECT_LT((model_at(q).gradient - numeric).cwiseAbs().maxCoeff(),
            1e-4 * numeric.cwiseAbs().maxCoeff());
}

TEST(ClearanceTerm, NothingBeyondTheBandOrSwitchedOff) {
  const ClearanceBench bench;
  ClearanceScratch scratch;
  const JointVector q = JointVector::Zero(static_cast<Eigen::Index>(bench.robot.joints()));
  ClearanceTerm term;
  term.weight = 0;
  solve::Quadratic model;
  model.reset(q.size());
  add_clearance(term, bench.world, q, 0, scratch, model);
  EXPECT_EQ(model.value, 0);
  EXPECT_EQ(model.gradient.norm(), 0);
}

}  // namespace
}  // namespace morphe::map
