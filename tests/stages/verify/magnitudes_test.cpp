#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "planar_plan.hpp"
#include "stages/verify/braking.hpp"
#include "stages/verify/mesh.hpp"
#include "stages/verify/separation.hpp"
#include "stages/verify/smoothness.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::verify {
namespace {

std::set<std::string> causes_in(const RobotModel& robot, const Plan& plan) {
  std::set<std::string> causes;
  for (const Violation& v : verify_plan(robot, "reach/000", plan))
    causes.insert(v.cause + " " + v.subject);
  return causes;
}

struct Hostile {
  const char* subject;  ///< of `structure`, beside which nothing else is noted
  std::function<void(RobotModel&, Plan&)> change;
};

/// On each of these verify worked without end, or took all memory.
TEST(VerifyMagnitudes, NumbersThatNoPlanHas) {
  const Hostile cases[] = {
      {"robot/capsules", [](RobotModel& robot, Plan&) { robot.capsules[1].to.x() = 1e200; }},
      {"robot/capsules", [](RobotModel& robot, Plan&) { robot.capsules[1].radius = HUGE_VAL; }},
      {"robot/frames",
       [](RobotModel& robot, Plan&) { robot.frames[1].transform.translation().y() = -1e9; }},
      {"robot/frames", [](RobotModel& robot, Plan&) { robot.frames[1].ratio = 1e6; }},
      {"trajectory/time", [](RobotModel&, Plan& plan) { plan.trajectory.time.back() = 1e12; }},
      {"trajectory/position",
       [](RobotModel&, Plan& plan) { plan.trajectory.position(5, 1) = 1e300; }},
      {"cup", [](RobotModel&, Plan& plan) { plan.scene.objects[1].size[0] = 1e200; }},
      {"cup", [](RobotModel&, Plan& plan) { plan.scene.objects[1].position[0].z() = 1e200; }},
      {"goals/tip_position",
       [](RobotModel&, Plan& plan) { plan.goals.tip_position(3, 1).x() = 1e200; }},
  };
  for (const Hostile& hostile : cases) {
    RobotModel robot = planar::robot();
    Plan plan = planar::plan();
    hostile.change(robot, plan);
    const std::set<std::string> found = causes_in(robot, plan);
    EXPECT_EQ(found.count(std::string("structure ") + hostile.subject), 1u) << hostile.subject;
    for (const std::string& cause : found) EXPECT_TRUE(cause.starts_with("structure ")) << cause;
  }
}

TEST(VerifyMagnitudes, GoalsSoDenseThatFiguresOfSmoothnessHaveNoEnd) {
  for (const double step_s : {1e-12, 2e-5}) {
    Plan plan = planar::plan();
    for (std::size_t k = 0; k < plan.goals.frames(); ++k)
      plan.goals.time[k] = 2 + step_s * static_cast<double>(k);
    EXPECT_EQ(causes_in(planar::robot(), plan).count("structure goals/time"), 1u) << step_s;
  }
}

TEST(VerifyMagnitudes, OfAnApproach) {
  Plan plan = planar::plan();
  plan.approach = plan.trajectory;
  for (double& time_s : plan.approach.time) time_s *= 1e6;
  EXPECT_EQ(causes_in(planar::robot(), plan).count("structure trajectory/time"), 1u);
}

/// The shoulder spins between any two samples, at the same height over the table and as far from a
/// goal on its axis as is just allowed: to prove either at every 0.01 mm would take hours.
TEST(VerifyMagnitudes, MotionsThatNobodyCanProve) {
  RobotModel robot = planar::robot();
  Plan plan = planar::plan(0.001);
  Trajectory& motion = plan.trajectory;
  motion.position.rowwise() = Eigen::RowVector3d(0, 0.5, 0.2);
  motion.velocity.setZero();
  motion.acceleration.setZero();
  for (Eigen::Index k = 1; k + 1 < motion.velocity.rows(); ++k) motion.velocity(k, 0) = 1e4;
  for (Vec3& goal : plan.goals.tip_position.values)
    if (is_known(goal)) goal = Vec3(0, 0, 0.1);
  const double away = (planar::tip_at({0, 0.5, 0.2}) - Vec3(0, 0, 0.1)).norm();
  plan.tolerances.tracking_tolerance = plan.tolerances.tracking_tolerance_grasp = away + 1e-9;
  plan.tolerances.required_clearance = 0.005 - 2e-5;
  const std::set<std::string> found = causes_in(robot, plan);
  EXPECT_EQ(found.count("tracking index"), 1u);
  EXPECT_EQ(found.count("object_collision distal/table"), 1u);
}

TEST(VerifyMagnitudes, SegmentsOfAnyLength) {
  SceneObject box;
  box.shape = Shape::box;
  box.size = {2, 2, 2};
  for (const double length : {1e3, 1e6, 1e9, 1e100})
    EXPECT_NEAR(
        segment_solid_distance(box, {Vec3(-length, 0, 1.5), Vec3(length, 0, 1.5)}, kInfinity), 0.5,
        1e-3)
        << length;
}

/// A segment 10 km long that lies 1 mm under the surface of a plate: as deep as it is, or as it
/// may be.
TEST(VerifyMagnitudes, ALongSegmentShallowInAMesh) {
  SceneObject plate;
  plate.shape = Shape::mesh;
  constexpr double kSide = 2e4;
  for (const double z : {-1.0, 0.0})
    for (const double y : {-kSide, kSide})
      for (const double x : {-kSide, kSide}) plate.vertices.emplace_back(x, y, z);
  for (const auto& t : {std::array{0, 2, 1},
                        {1, 2, 3},
                        {4, 5, 6},
                        {5, 7, 6},
                        {0, 1, 4},
                        {1, 5, 4},
                        {2, 6, 3},
                        {3, 6, 7},
                        {0, 4, 2},
                        {2, 4, 6},
                        {1, 3, 5},
                        {3, 7, 5}})
    plate.triangles.emplace_back(t[0], t[1], t[2]);
  const Mesh mesh = make_mesh(plate);
  const double found =
      segment_mesh_distance(mesh, {Vec3(-5e3, 10, -1e-3), Vec3(5e3, 10, -1e-3)}, kInfinity);
  EXPECT_LE(found, -1e-3 / 1.05);
}

/// What a braking curve leaves is used up to the same share all along.
TEST(VerifyMagnitudes, ABrakingCurveThatIsFollowed) {
  // v = sqrt(slope (end - q)): q = end - slope (T - t)^2 / 4.
  RobotModel::BrakingCurve curve{0, 4, 0, -9, 1};
  const auto state = [](double left_s) { return JointState{1 - left_s * left_s, 2 * left_s, -2}; };
  const BrakingLimitUse use = max_braking_use(curve, quintic_between(0.5, state(1.5), state(1)), 0);
  EXPECT_NEAR(use.ratio, 1, 1e-3);
  EXPECT_GE(use.ratio, 1 - 1e-9);
}

/// Against the sum that defines the spectrum, also where a power of two is met exactly.
TEST(VerifySmoothness, ArcLengthIsThatOfTheSumItself) {
  for (const int count : {3, 64, 65, 200}) {
    constexpr double kStep_s = 0.02;
    std::vector<double> speed;
    for (int k = 0; k < count; ++k)
      speed.push_back(std::pow(std::sin(std::numbers::pi * (k + 1) / (count + 1)), 2) +
                      0.1 * std::sin(0.9 * k) * std::sin(0.9 * k));
    const double padded = 16 * std::exp2(std::ceil(std::log2(count)));
    std::vector<double> magnitude;
    for (int k = 0; k / (padded * kStep_s) <= 10; ++k) {
      double re = 0, im = 0;
      for (int i = 0; i < count; ++i) {
        const double angle =
            2 * std::numbers::pi * std::fmod(static_cast<double>(k) * i, padded) / padded;
        re += speed[static_cast<std::size_t>(i)] * std::cos(angle);
        im += speed[static_cast<std::size_t>(i)] * std::sin(angle);
      }
      magnitude.push_back(std::hypot(re, im));
    }
    while (magnitude.back() < 0.05 * magnitude.front()) magnitude.pop_back();
    double length = 0;
    for (std::size_t k = 1; k < magnitude.size(); ++k)
      length += std::hypot(1 / static_cast<double>(magnitude.size() - 1),
                           (magnitude[k] - magnitude[k - 1]) / magnitude.front());
    EXPECT_NEAR(sparc(speed, kStep_s), -length, 1e-10) << count;
  }
}

}  // namespace
}  // namespace morphe::verify
