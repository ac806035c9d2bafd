#include "stages/map/movement_search.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/support/two_link_arm.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

/// A planar arm whose tip moves through goals that the elbow can serve from either side, while the
/// person's elbow changes sides: whether to follow it, and when, is the question.
struct TwoSides {
  robot::Robot robot;
  Scene scene;
  collision::CollisionWorld world;
  MappingProblem problem;
  MapOptions options;
  JointVector weight;  ///< on squared differences of neighbouring frames

  TwoSides(const TwoSides&) = delete;
  TwoSides(std::mt19937_64& random, double humanlike) {
    RobotModel table = two_link_arm();
    RobotModel::Tip tip;
    tip.frame = 1;
    tip.transform.translation() = Vec3(0.5, 0, 0);
    table.tips = {tip};
    table.joint_centres = {{1, "arm"}};
    table.palm_frame = 1;
    table.velocity = table.acceleration = table.jerk = JointVector::Constant(2, 2);
    robot = robot::Robot(table);
    world = collision::make_world(robot, scene, {}, {});
    options.movement_cost = {3e-4, 0, 0};
    options.coarse_step_s = kReferenceStep_s;
    problem.robot = &robot;
    problem.world = &world;
    problem.clearance.weight = 0;
    problem.objective.get<humanlike::TipPosition>().weight = 100;
    problem.objective.get<humanlike::JointDistance>().weight = humanlike;
    std::uniform_real_distribution<double> anywhere(0, 1);
    const double turned = 2 * anywhere(random), side = anywhere(random), at = anywhere(random);
    constexpr std::size_t kFrames = 12;
    for (std::size_t f = 0; f < kFrames; ++f) {
      const double s = static_cast<double>(f) / (kFrames - 1);
      humanlike::FrameGoal goal;
      const double angle = turned + 0.5 * s;
      goal.tip_position = {Vec3(0.7 * std::cos(angle), 0.7 * std::sin(angle), 0)};
      goal.tip_orientation = {unknown_rotation()};
      const double aside = 0.5 * (s < at ? -side : 1 - side);
      goal.elbow =
          Vec3(-aside * std::sin(angle), aside * std::cos(angle), 0) + goal.tip_position[0] / 2;
      problem.goals.push_back(goal);
      problem.time.push_back(kReferenceStep_s * static_cast<double>(f));
    }
    weight = difference_weights(robot, problem.time, options.movement_cost)[0];
  }

  double of_frame(std::size_t frame, const JointVector& q) const {
    humanlike::ObjectiveScratch scratch;
    solve::Quadratic model;
    model.reset(q.size());
    humanlike::add_objective(problem.objective, robot, q, problem.goals[frame], scratch, model,
                             humanlike::Curvature::none);
    return model.value;
  }
  double of_course(const JointRows& q) const {
    double sum = 0;
    for (Index f = 0; f < q.rows(); ++f) {
      sum += of_frame(static_cast<std::size_t>(f), q.row(f).transpose());
      if (f == 0) continue;
      sum += (q.row(f) - q.row(f - 1)).cwiseAbs2() * weight;
    }
    return sum;
  }

  /// The best of all courses whose joints stand on a grid, by dynamic programming, one joint of a
  /// step after the other.
  double best_on_grid(int count) const {
    const double step = (robot.upper[0] - robot.lower[0]) / (count - 1);
    const auto n = static_cast<Index>(count);
    const auto moved = [&](const Eigen::MatrixXd& value, double w) {  // along the columns
      Eigen::MatrixXd out(n, n);
      for (Index to = 0; to < n; ++to) {
        Eigen::RowVectorXd least =
            Eigen::RowVectorXd::Constant(n, std::numeric_limits<double>::infinity());
        for (Index from = 0; from < n; ++from) {
          const double away = step * static_cast<double>(to - from);
          least = least.cwiseMin((value.row(from).array() + w * away * away).matrix());
        }
        out.row(to) = least;
      }
      return out;
    };
    Eigen::MatrixXd value = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t f = 0; f < problem.frames(); ++f) {
      if (f > 0) {
        value = moved(value, weight[0]);
        value = moved(Eigen::MatrixXd(value.transpose()), weight[1]).transpose().eval();
      }
      for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
          value(i, j) +=
              of_frame(f, Eigen::Vector2d(robot.lower[0] + step * static_cast<double>(i),
                                          robot.lower[1] + step * static_cast<double>(j)));
        }
      }
    }
    return value.minCoeff();
  }
};

TEST(MovementSearch, IsNotWorseThanTheBestOfAllCoursesOnAGrid) {
  std::mt19937_64 random(3);
  int changes = 0, stays = 0;
  for (int k = 0; k < 12; ++k) {
    const TwoSides of(random, 3.0 * k);
    const std::vector<CandidatePath> courses = search_movement(of.problem, of.options, 1);
    ASSERT_FALSE(courses.empty());
    const JointRows& q = courses.front().q;
    EXPECT_NEAR(courses.front().value, of.of_course(q), 1e-6) << k;
    EXPECT_LE(of.of_course(q), of.best_on_grid(121) + 1e-9) << k;
    (q(0, 1) * q(q.rows() - 1, 1) < 0 ? changes : stays) += 1;
    for (std::size_t c = 1; c < courses.size(); ++c) {
      const double rounding = c == 1 ? 1e-4 * courses[1].value : 0;  // the first one left the grid
      EXPECT_LE(courses[c - 1].value, courses[c].value + rounding) << "the best comes first";
    }
  }
  EXPECT_GT(changes, 0) << "the elbow changed sides in none";
  EXPECT_GT(stays, 0) << "the elbow changed sides in all";
}

TEST(MovementSearch, ACourseThroughAPosturePassesNearIt) {
  std::mt19937_64 random(4);
  const TwoSides of(random, 1);
  const JointRows best = search_movement(of.problem, of.options, 1).front().q;
  JointVector mirrored = best.row(6).transpose();  // the other elbow for the same tip
  const double beyond = std::atan2(0.5 * std::sin(mirrored[1]), 0.5 + 0.5 * std::cos(mirrored[1]));
  mirrored[0] += 2 * beyond;
  mirrored[1] *= -1;
  const CandidatePath through = path_through(of.problem, 6, mirrored, of.options);
  EXPECT_GT(through.q(6, 1) * mirrored[1], 0) << "on the side that was asked for";
  EXPECT_GE(of.of_course(through.q), of.of_course(best) - 1e-9);
}

TEST(MovementSearch, APostureBehindTheLastFrameIsThatOfTheLastFrame) {
  std::mt19937_64 random(4);
  const TwoSides of(random, 1);
  const std::size_t last = of.problem.time.size() - 1;
  const JointVector posture = JointVector::Constant(2, 0.3);
  const CandidatePath at_last = path_through(of.problem, last, posture, of.options);
  for (const std::size_t beyond : {last + 1, last + 1000})
    EXPECT_EQ(path_through(of.problem, beyond, posture, of.options).q, at_last.q);
}

}  // namespace
}  // namespace morphe::map
