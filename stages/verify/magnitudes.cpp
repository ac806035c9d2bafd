#include "stages/verify/magnitudes.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kMaxLength_m = 1e6, kMaxJointPosition = 1e6, kMaxCouplingRatio = 1e3;
constexpr double kMaxMotionDuration_s = 6 * 3600.0, kMinGoalStep_s = 1e-5;
constexpr double kMaxGoalSteps = 4e6, kGoalStepAllowance = 1000, kMaxGoalStepsPerSample = 100;

/// Keeps the largest magnitude of each dataset; NaN is ignored.
class MagnitudeChecker {
 public:
  explicit MagnitudeChecker(ViolationCollector& runs) : runs_(runs) {}

  template <class Values>
  void largest(const char* subject, const Values& values, double most) {
    at_most(subject,
            values.size() > 0 ? values.cwiseAbs().template maxCoeff<Eigen::PropagateNumbers>() : 0,
            most);
  }
  void at_most(const char* subject, double value, double most) {
    if (!(value > most)) return;
    runs_.note_plan("structure", subject, value, most);
    good_ = false;
  }
  bool good() const { return good_; }

 private:
  ViolationCollector& runs_;
  bool good_ = true;
};

void check_magnitudes(const RobotModel& robot, MagnitudeChecker& look) {
  for (const RobotModel::Frame& frame : robot.frames) {
    look.largest("robot/frames", frame.transform.translation(), kMaxLength_m);
    if (frame.joint < 0) continue;
    look.at_most("robot/frames", std::abs(frame.ratio), kMaxCouplingRatio);
    look.at_most("robot/frames", std::abs(frame.offset), kMaxLength_m);
  }
  for (const RobotModel::Tip& tip : robot.tips)
    look.largest("robot/tips", tip.transform.translation(), kMaxLength_m);
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    look.largest("robot/capsules", capsule.from, kMaxLength_m);
    look.largest("robot/capsules", capsule.to, kMaxLength_m);
    look.at_most("robot/capsules", capsule.radius, kMaxLength_m);
  }
  look.largest("robot/lower, upper", robot.lower, kMaxJointPosition);
  look.largest("robot/lower, upper", robot.upper, kMaxJointPosition);
}

void check_magnitudes(const SceneObject& object, MagnitudeChecker& look) {
  const char* const name = object.name.c_str();
  for (const double length : object.size) look.at_most(name, length, kMaxLength_m);
  for (const Vec3& place : object.position) look.largest(name, place, kMaxLength_m);
  for (const Vec3& vertex : object.vertices) look.largest(name, vertex, kMaxLength_m);
}

void check_magnitudes(const Goals& goals, MagnitudeChecker& look) {
  for (const Vec3& goal : goals.tip_position.values)
    look.largest("goals/tip_position", goal, kMaxLength_m);
}

void check_magnitudes(const Trajectory& motion, MagnitudeChecker& look) {
  look.largest("trajectory/position", motion.position, kMaxJointPosition);
  look.at_most("trajectory/time", motion.time.back() - motion.time.front(), kMaxMotionDuration_s);
}

/// Checks the number of steps of the goals, at each of which the smoothness measures are evaluated.
void check_goal_steps(const Plan& plan, MagnitudeChecker& look) {
  const std::vector<double>& goals = plan.goals.time;
  if (goals.size() < 2) return;
  const double step_s = (goals.back() - goals.front()) / static_cast<double>(goals.size() - 1);
  look.at_most("goals/time", 1 / step_s, 1 / kMinGoalStep_s);
  const std::vector<double>& time = plan.trajectory.time;
  const double samples = static_cast<double>(time.size());
  look.at_most("goals/time", (time.back() - time.front()) / step_s,
               std::min(kMaxGoalSteps, kGoalStepAllowance + kMaxGoalStepsPerSample * samples));
}

}  // namespace

bool verify_magnitudes(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  MagnitudeChecker look(runs);
  check_magnitudes(robot, look);
  for (const SceneObject& object : plan.scene.objects) check_magnitudes(object, look);
  check_magnitudes(plan.goals, look);
  check_magnitudes(plan.trajectory, look);
  check_goal_steps(plan, look);
  return look.good();
}

bool verify_magnitudes(const Trajectory& motion, ViolationCollector& runs) {
  MagnitudeChecker look(runs);
  check_magnitudes(motion, look);
  return look.good();
}

}  // namespace morphe::verify
