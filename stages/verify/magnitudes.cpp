#include "stages/verify/magnitudes.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kMaxLength_m = 1e6, kMaxJointPosition = 1e6, kMaxCouplingRatio = 1e3;
constexpr double kMaxCouplingOffset = 1e6, kMaxDuration_s = 6 * 3600.0, kMinGoalStep_s = 1e-5;
constexpr double kMaxGoalSteps = 4e6, kBaseGoalSteps = 1000, kMaxGoalStepsPerSample = 100;

/// Records each value above its limit, infinity included. NaN is ignored.
class MagnitudeChecker {
 public:
  explicit MagnitudeChecker(ViolationLog& violations) : violations_(violations) {}
  template <class Values>
  void check_all(const char* subject, const Values& values, double limit) {
    check(subject,
          values.size() > 0 ? values.cwiseAbs().template maxCoeff<Eigen::PropagateNumbers>() : 0,
          limit);
  }
  void check(const char* subject, double value, double limit) {
    if (!(value > limit)) return;
    violations_.note_plan("structure", subject, value, limit);
    within_limits_ = false;
  }
  bool within_limits() const { return within_limits_; }

 private:
  ViolationLog& violations_;
  bool within_limits_ = true;
};

void check_magnitudes(const RobotModel& robot, MagnitudeChecker& checker) {
  for (const RobotModel::Frame& frame : robot.frames) {
    checker.check_all("robot/frames", frame.transform.translation(), kMaxLength_m);
    if (frame.joint < 0) continue;
    checker.check("robot/frames", std::abs(frame.ratio), kMaxCouplingRatio);
    checker.check("robot/frames", std::abs(frame.offset), kMaxCouplingOffset);
  }
  for (const RobotModel::Tip& tip : robot.tips)
    checker.check_all("robot/tips", tip.transform.translation(), kMaxLength_m);
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    checker.check_all("robot/capsules", capsule.from, kMaxLength_m);
    checker.check_all("robot/capsules", capsule.to, kMaxLength_m);
    checker.check("robot/capsules", capsule.radius, kMaxLength_m);
  }
  checker.check_all("robot/lower, upper", robot.lower, kMaxJointPosition);
  checker.check_all("robot/lower, upper", robot.upper, kMaxJointPosition);
}

void check_magnitudes(const SceneObject& object, MagnitudeChecker& checker) {
  const char* const name = object.name.c_str();
  for (const double length : object.size) checker.check(name, length, kMaxLength_m);
  for (const Vec3& place : object.position) checker.check_all(name, place, kMaxLength_m);
  for (const Vec3& vertex : object.vertices) checker.check_all(name, vertex, kMaxLength_m);
}

void check_magnitudes(const Trajectory& trajectory, MagnitudeChecker& checker) {
  checker.check_all("trajectory/position", trajectory.position, kMaxJointPosition);
  checker.check("trajectory/time", trajectory.time.back() - trajectory.time.front(),
                kMaxDuration_s);
}

/// Checks the steps between goal frames, at each of which the smoothness measures are evaluated.
void check_goal_steps(const Plan& plan, MagnitudeChecker& checker) {
  const std::vector<double>& goal_s = plan.goals.time;
  if (goal_s.size() < 2) return;
  const double step_s = (goal_s.back() - goal_s.front()) / static_cast<double>(goal_s.size() - 1);
  checker.check("goals/time", 1 / step_s, 1 / kMinGoalStep_s);
  const std::vector<double>& time = plan.trajectory.time;
  const double samples = static_cast<double>(time.size());
  checker.check("goals/time", (time.back() - time.front()) / step_s,
                std::min(kMaxGoalSteps, kBaseGoalSteps + kMaxGoalStepsPerSample * samples));
}

}  // namespace

bool verify_magnitudes(const RobotModel& robot, const Plan& plan, ViolationLog& violations) {
  MagnitudeChecker checker(violations);
  check_magnitudes(robot, checker);
  for (const SceneObject& object : plan.scene.objects) check_magnitudes(object, checker);
  for (const Vec3& goal : plan.goals.tip_position.values)
    checker.check_all("goals/tip_position", goal, kMaxLength_m);
  check_magnitudes(plan.trajectory, checker);
  check_goal_steps(plan, checker);
  return checker.within_limits();
}

bool verify_magnitudes(const Trajectory& trajectory, ViolationLog& violations) {
  MagnitudeChecker checker(violations);
  check_magnitudes(trajectory, checker);
  return checker.within_limits();
}

}  // namespace morphe::verify
