#include <gtest/gtest.h>

#include "core/humanlike/frame_objective.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/files/generate.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/solve/minimise.hpp"
#include "tests/support/random_positions.hpp"

namespace morphe::humanlike {
namespace {

/// Frames of the paper's kinds: goals that the robot's own tips make, the elbow somewhere else.
class SolversAgree : public testing::TestWithParam<std::string> {
 protected:
  static RobotModel robot_called(const std::string& name) {
    if (name == "arm_9") return robot::generate_arm({9, 0.58, 1.5});
    if (name == "arm_21") return robot::generate_arm({21, 0.58, 1.5});
    return robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/" + name + ".yaml").table;
  }

  static FrameGoal goal_at(const RobotModel& robot, const JointVector& q) {
    FrameGoal goal;
    std::vector<Pose> poses;
    robot::forward_kinematics(robot, q, poses);
    for (std::size_t i = 0; i < robot.tips.size(); ++i) {
      const Pose tip = robot::tip_pose(robot, poses, i);
      goal.tip_position.push_back(tip.translation());
      goal.tip_orientation.push_back(robot.tips.size() == 1 ? Quat(tip.linear())
                                                            : unknown_rotation());
    }
    goal.elbow = poses[robot.frames.size() / 2].translation() + Vec3(0.05, 0, 0.1);
    goal.finger_joint.fill(unknown_point());
    return goal;
  }
};

TEST_P(SolversAgree, OnTheMinimumNextToAStart) {
  const robot::Robot robot(robot_called(GetParam()));
  FrameObjective objective;
  objective.get<TipPosition>().weight = 1000;
  objective.get<JointDistance>().weight = 1;
  objective.get<TipOrientation>().weight = 1;
  std::mt19937_64 random(8);
  int same = 0, evaluations = 0;
  for (int k = 0; k < 20; ++k) {
    const JointVector made = random_position(robot, random, 0.6);
    const FrameGoal goal = goal_at(robot, made);
    ObjectiveScratch scratch;
    solve::Quadratic value;
    solve::BoundedProblem problem;
    problem.lower = robot.lower;
    problem.upper = robot.upper;
    problem.objective = [&](const JointVector& q, JointVector* gradient) {
      value.reset(q.size());
      add_objective(objective, robot, q, goal, scratch, value, Curvature::none);
      if (gradient) *gradient = value.gradient;
      return value.value;
    };
    problem.model = [&](const JointVector& q, solve::Quadratic& model) {
      add_objective(objective, robot, q, goal, scratch, model, Curvature::exact);
    };
    solve::MinimiseOptions options;
    options.max_evaluations = 5000;
    const solve::Minimum ours = solve::minimise(problem, made, options);
    EXPECT_TRUE(ours.converged);
    EXPECT_LT(ours.evaluations, 400);
    evaluations += ours.evaluations;
    for (const char* algorithm : {"tnewton", "slsqp", "lbfgs"}) {
      options.algorithm = algorithm;
      // From the same start it may find another minimum; from ours it must not find a better one.
      const solve::Minimum theirs = solve::minimise(problem, made, options);
      same += std::abs(theirs.value - ours.value) < 1e-6 ? 1 : 0;
      EXPECT_GT(solve::minimise(problem, ours.x, options).value, ours.value - 1e-8) << algorithm;
    }
    options.algorithm = "trust_region";
    scratch.new_descent();
  }
  EXPECT_GE(same, 45);  // of 60
  EXPECT_LT(evaluations, 3000);
}

INSTANTIATE_TEST_SUITE_P(Robots, SolversAgree,
                         testing::Values("pa10", "dlr_hit2", "pa10_dlr_hit2", "arm_9", "arm_21"));

}  // namespace
}  // namespace morphe::humanlike
