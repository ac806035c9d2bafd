#include "core/humanlike/chain_gradients.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/humanlike/frame_objective.hpp"
#include "core/humanlike/hull.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/support/finite_differences.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::humanlike {
namespace {

/// The same points from every compiler: arguments would be drawn in an order of its own, and beside
/// a fold of the hull differences say nothing.
Vec3 random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<> share(-0.5, 0.5);
  const double z = share(random), y = share(random), x = share(random);
  return {x, y, z};
}

Chain random_chain(std::size_t joints, std::mt19937_64& random) {
  Chain chain{random_point(random)};
  while (chain.size() < joints) chain.push_back(chain.back() + random_point(random));
  return chain;
}

JointVector flat(const Chain& chain) {
  JointVector numbers(3 * static_cast<Eigen::Index>(chain.size()));
  for (std::size_t i = 0; i < chain.size(); ++i) {
    numbers.segment<3>(3 * static_cast<Eigen::Index>(i)) = chain[i];
  }
  return numbers;
}

Chain chain_of(const JointVector& numbers) {
  Chain chain;
  for (Eigen::Index i = 0; i < numbers.size(); i += 3) chain.push_back(numbers.segment<3>(i));
  return chain;
}

template <class Metric>
void expect_slopes(const Metric& metric, const Chain& robot) {
  const JointVector numeric = numeric_gradient(
      [&](const JointVector& numbers) { return metric(chain_of(numbers)).value; }, flat(robot));
  const JointVector analytic = flat(metric(robot).gradient);
  EXPECT_LT((analytic - numeric).cwiseAbs().maxCoeff(), 1e-6 * numeric.cwiseAbs().maxCoeff());
}

TEST(ChainSlopes, TriangleAreasOfAnyChains) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 100; ++k) {
    const Chain human = random_chain(3, random);
    const Chain robot = random_chain(3 + static_cast<std::size_t>(k % 8), random);
    const auto metric = [&](const Chain& chain) { return triangle_area_gradient(human, chain, 0); };
    EXPECT_NEAR(metric(robot).value, triangle_area_sum(human, robot), 1e-12);
    expect_slopes(metric, robot);
  }
}

TEST(ChainSlopes, HullVolumesOfAnyChains) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 100; ++k) {
    const Chain human = random_chain(3, random);
    const Chain robot = random_chain(4 + static_cast<std::size_t>(k % 8), random);
    expect_slopes([&](const Chain& chain) { return hull_volume_gradient(human, chain); }, robot);
  }
}

TEST(ChainSlopes, CoincidentChainsAreAtTheMinimumOfB) {
  const Chain chain{{0, 0, 0}, {0.3, 0, 0}, {0.3, 0, -0.25}};
  const ChainGradient metric = triangle_area_gradient(chain, chain, 1e-6);
  EXPECT_NEAR(metric.value, 0, 1e-12);
  for (const Vec3& slope : metric.gradient) EXPECT_LT(slope.norm(), 1e-9);
}

TEST(ChainSlopes, APlanarArmHasNoVolumeAndNoSlope) {
  const Chain human{{0, 0, 0}, {0.3, 0, 0}, {0.5, 0.2, 0}};
  const Chain robot{{0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0.1, 0}, {0.4, 0.3, 0}, {0.5, 0.2, 0}};
  const ChainGradient metric = hull_volume_gradient(human, robot);
  EXPECT_EQ(metric.value, 0);
  for (const Vec3& slope : metric.gradient) EXPECT_EQ(slope.norm(), 0);
}

TEST(Hull, ASimplexIsADeterminantWhateverItsOrder) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 50; ++k) {
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i) points.push_back(random_point(random));
    Eigen::Matrix3d edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = points[static_cast<std::size_t>(i) + 1] - points[0];
    EXPECT_NEAR(hull_gradient(points).value, std::abs(edges.determinant()) / 6, 1e-15);
  }
}

TEST(Hull, APointInsideACubeChangesNothing) {
  std::vector<Vec3> cube;
  for (int i = 0; i < 8; ++i) cube.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  EXPECT_NEAR(hull_gradient(cube).value, 1, 1e-12);
  cube.emplace_back(0.5, 0.5, 0.5);
  EXPECT_NEAR(hull_gradient(cube).value, 1, 1e-12);
}

TEST(Hull, FlatSetsHaveNoVolume) {
  EXPECT_EQ(hull_gradient({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).value, 0);
  EXPECT_EQ(hull_gradient({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.6, 0}}).value, 0);
}

/// Quickhull against the definition: a facet has all points on one side, and only facets do.
TEST(Hull, QuickhullFindsEveryTriangleWithAllPointsBehindIt) {
  std::mt19937_64 random(6);
  for (int k = 0; k < 30; ++k) {
    std::vector<Vec3> points;
    for (int i = 0; i < 5 + k % 10; ++i) points.push_back(random_point(random));
    double volume = 0;
    std::size_t count = 0;
    for (const Vec3& a : points) {
      for (const Vec3& b : points) {
        for (const Vec3& c : points) {
          const Vec3 normal = (b - a).cross(c - a);
          if (normal.norm() == 0) continue;
          const bool outside =
              std::ranges::all_of(points, [&](const Vec3& p) { return normal.dot(p - a) < 1e-12; });
          if (!outside) continue;
          volume += a.dot(b.cross(c)) / 6 / 3;  // each one in three orders
          ++count;
        }
      }
    }
    EXPECT_EQ(hull_facets(points).size(), count / 3);
    EXPECT_NEAR(hull_gradient(points).value, volume, 1e-14);
  }
}

/// All terms together on arms and hands of every kind, against differences of fourth order.
TEST(FrameObjective, GradientOnRandomRobots) {
  const std::string robots = MORPHE_SOURCE_DIR "/configs/robots/";
  const robot::ArmSpec arm{11, 0.6};
  const std::vector<RobotModel> kinds{robot::load_robot(robots + "pa10.yaml").table,
                                      robot::load_robot(robots + "dlr_hit2.yaml").table,
                                      robot::load_robot(robots + "pa10_dlr_hit2.yaml").table,
                                      robot::generate_arm(arm),
                                      robot::generate_arm({44, 0.5}),
                                      robot::generate_arm_hand(arm, {5, 0.19, 0.085})};
  FrameObjective objective;
  objective.get<TipPosition>().weight = 7;
  objective.get<TipOrientation>().weight = 0.6;
  objective.get<HandOrientation>().weight = 0.3;
  objective.get<JointDistance>().weight = 1;
  objective.get<FingerJointDistance>().weight = 1;
  objective.get<NaturalPosture>().weight = 1e-3;
  objective.get<TriangleArea>().weight = 2;
  objective.get<HullVolume>().weight = 30;
  objective.get<NaturalPosture>().joints = {{1, 0, 0.1, {}}};
  std::mt19937_64 random(9);
  for (const RobotModel& kind : kinds) {
    const robot::Robot robot(kind);
    for (int k = 0; k < 10; ++k) {
      FrameGoal goal;
      for (std::size_t i = 0; i < robot.tips.size(); ++i) {
        const bool missing = i > 0 && (i + static_cast<std::size_t>(k)) % 3 == 0;
        goal.tip_position.push_back(missing ? unknown_point() : random_point(random));
        goal.tip_orientation.push_back(
            i % 2 ? unknown_rotation()
                  : Quat(Eigen::Vector4d(1, 0.3, random_point(random).x(), 0.2).normalized()));
      }
      goal.hand = Quat(1, 0.2 * k, -0.4, 0.3).normalized();
      goal.shoulder = random_point(random);
      goal.elbow = goal.shoulder + random_point(random);
      goal.wrist = goal.elbow + random_point(random);
      for (Vec3& joint : goal.finger_joint) joint = random_point(random);
      goal.weights.humanlike_arm = 0.5;

      const JointVector q = random_position(robot, random);
      ObjectiveScratch scratch;
      solve::Quadratic model;
      const auto value = [&](const JointVector& at) {
        model.reset(q.size());
        add_objective(objective, robot, at, goal, scratch, model, Curvature::none);
        return model.value;
      };
      const double step = 1e-4;  // short, so that no joint enters a hull
      const JointVector numeric =
          (4 * numeric_gradient(value, q, step) - numeric_gradient(value, q, 2 * step)) / 3;
      value(q);
      const double scale = numeric.cwiseAbs().maxCoeff();
      EXPECT_LT((model.gradient - numeric).cwiseAbs().maxCoeff(), 1e-6 * scale) << robot.name;
    }
  }
}

}  // namespace
}  // namespace morphe::humanlike
