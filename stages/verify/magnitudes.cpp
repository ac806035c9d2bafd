#include "stages/verify/magnitudes.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::verify {
namespace {

constexpr double kFarthest_m = 1e6, kMostJoint = 1e6, kMostRatio = 1e3;
constexpr double kLongest_s = 6 * 3600.0, kLeastStep_s = 1e-5;
constexpr double kMostSteps = 4e6, kStepsAtLeast = 1000, kStepsPerSample = 100;

/// Keeps the largest of each dataset; NaN is no magnitude.
class Look {
 public:
  explicit Look(ViolationRuns& runs) : runs_(runs) {}

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
  ViolationRuns& runs_;
  bool good_ = true;
};

void look_at(const RobotTable& robot, Look& look) {
  for (const RobotTable::Frame& frame : robot.frames) {
    look.largest("robot/frames", frame.transform.translation(), kFarthest_m);
    if (frame.joint < 0) continue;
    look.at_most("robot/frames", std::abs(frame.ratio), kMostRatio);
    look.at_most("robot/frames", std::abs(frame.offset), kFarthest_m);
  }
  for (const RobotTable::Tip& tip : robot.tips)
    look.largest("robot/tips", tip.transform.translation(), kFarthest_m);
  for (const RobotTable::Capsule& capsule : robot.capsules) {
    look.largest("robot/capsules", capsule.from, kFarthest_m);
    look.largest("robot/capsules", capsule.to, kFarthest_m);
    look.at_most("robot/capsules", capsule.radius, kFarthest_m);
  }
  look.largest("robot/lower, upper", robot.lower, kMostJoint);
  look.largest("robot/lower, upper", robot.upper, kMostJoint);
}

void look_at(const SceneObject& object, Look& look) {
  const char* const name = object.name.c_str();
  for (const double length : object.size) look.at_most(name, length, kFarthest_m);
  for (const Vec3& place : object.position) look.largest(name, place, kFarthest_m);
  for (const Vec3& vertex : object.vertices) look.largest(name, vertex, kFarthest_m);
}

void look_at(const Goals& goals, Look& look) {
  for (const Vec3& goal : goals.tip_position.values)
    look.largest("goals/tip_position", goal, kFarthest_m);
}

void look_at(const Trajectory& motion, Look& look) {
  look.largest("trajectory/position", motion.position, kMostJoint);
  look.at_most("trajectory/time", motion.time.back() - motion.time.front(), kLongest_s);
}

/// Figures of smoothness are taken at every step of the goals.
void look_at_steps(const Plan& plan, Look& look) {
  const std::vector<double>& goals = plan.goals.time;
  if (goals.size() < 2) return;
  const double step_s = (goals.back() - goals.front()) / static_cast<double>(goals.size() - 1);
  look.at_most("goals/time", 1 / step_s, 1 / kLeastStep_s);
  const std::vector<double>& time = plan.trajectory.time;
  const double samples = static_cast<double>(time.size());
  look.at_most("goals/time", (time.back() - time.front()) / step_s,
               std::min(kMostSteps, kStepsAtLeast + kStepsPerSample * samples));
}

}  // namespace

bool judge_magnitudes(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  Look look(runs);
  look_at(robot, look);
  for (const SceneObject& object : plan.scene.objects) look_at(object, look);
  look_at(plan.goals, look);
  look_at(plan.trajectory, look);
  look_at_steps(plan, look);
  return look.good();
}

bool judge_magnitudes(const Trajectory& motion, ViolationRuns& runs) {
  Look look(runs);
  look_at(motion, look);
  return look.good();
}

}  // namespace morphe::verify
