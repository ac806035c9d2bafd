#include "pipeline/explain/palm_floor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/solve/minimise.hpp"
#include "pipeline/planning/place_movement.hpp"

namespace morphe::explain {
namespace {

constexpr std::size_t kSamples = 16;  ///< chosen by hand: seconds for all, and one per 0.1 s
/// A tip off its place by this costs as much as the palm off by 1 rad, so that the least value has
/// tips within about 0.01 mm.
constexpr double kTipScale_m = 1e-3;
/// A search whose tips end farther from their places has failed.
constexpr double kMaxTipError_m = 1e-4;
constexpr double kDifference = 1e-6;  ///< of a variable, for the derivatives [rad or m]
constexpr Eigen::Index kPalmVariables = 6;

/// The tips that must stay, and the palm's goal, at one sample.
struct HeldTips {
  std::vector<int> tips;
  std::vector<Vec3> places;
  Quat hand = unknown_rotation();
};

/// A palm, the tips' distances from their places and the palm's rotation from the hand.
using Residuals = Eigen::VectorXd;

Residuals residuals_of(const Quat& palm, const std::vector<Vec3>& points, const HeldTips& held) {
  Residuals out(3 * std::ssize(points) + 3);
  for (Eigen::Index i = 0; i < std::ssize(points); ++i)
    out.segment<3>(3 * i) = (points[i] - held.places[i]) / kTipScale_m;
  const Eigen::AngleAxisd turn(held.hand.conjugate() * palm);
  out.tail<3>() = turn.angle() * turn.axis();
  return out;
}

/// One sample's problem: the variables are all joints, or the palm's shift and turn from its driven
/// pose, followed by all joints.
class PalmProblem {
 public:
  PalmProblem(const robot::Robot& robot, const Plan& plan, int sample, bool free_palm)
      : robot_(robot), posture_(plan.trajectory.position.row(sample).transpose()) {
    free_palm_ = free_palm;
    robot::forward_kinematics(robot, posture_, frames_);
    palm_ = frames_[robot.palm_frame];
    const double time_s = plan.trajectory.demonstration_time[sample];
    held_.hand = wrist_orientation_at(plan.goals, time_s);
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      if (robot.tips[tip].finger < 0 || !is_known(tip_goal_at(plan.goals, tip, time_s))) continue;
      held_.tips.push_back(tip);
      held_.places.push_back(robot::tip_pose(robot, frames_, tip).translation());
    }
  }

  bool has_goals() const { return is_known(held_.hand) && !held_.tips.empty(); }
  double driven() const { return angle_between(Quat(palm_.linear()), held_.hand); }

  /// Returns the least angle that local searches find, of those that keep the tips in their places:
  /// from the driven posture, and from it with the palm turned to the hand, or with other fingers.
  double least_angle(const JointVector& other_fingers) {
    double least = driven();
    for (const JointVector& start : {with_palm(posture_, 0), other_start(other_fingers)}) {
      const JointVector x = minimum_from(start);
      const Residuals found = residuals(x);
      if (kTipScale_m * found.head(found.size() - 3).cwiseAbs().maxCoeff() > kMaxTipError_m)
        continue;
      if (found.tail<3>().norm() >= least) continue;
      least = found.tail<3>().norm();
      best_joints = x.tail(posture_.size());
    }
    return least;
  }

  JointVector best_joints;  ///< of the least angle; empty if it is the driven one

 private:
  JointVector minimum_from(const JointVector& start) {
    solve::BoundedProblem problem;
    problem.lower = with_palm(robot_.lower, -1);
    problem.upper = with_palm(robot_.upper, 1);
    problem.model = [this](const JointVector& x, solve::Quadratic& model) { add_to(x, model); };
    return solve::minimise(problem, start, {}).x;
  }

  /// Returns the driven posture with the palm turned to the hand if it is free, else with the
  /// joints beyond the arm of another posture, if there is one.
  JointVector other_start(const JointVector& other_fingers) const {
    JointVector start = with_palm(posture_, 0);
    if (free_palm_) {
      const Eigen::AngleAxisd turn(held_.hand * Quat(palm_.linear()).conjugate());
      start.segment<3>(3) = turn.angle() * turn.axis();
    } else if (other_fingers.size() > 0) {
      start = other_fingers;
      for (const int joint : robot_.arm_joints) start[joint] = posture_[joint];
    }
    return start;
  }

  /// Returns the joints, after the free palm's variables if there are any: `bound` times 1 m and
  /// pi.
  JointVector with_palm(const JointVector& joints, double bound) const {
    if (!free_palm_) return joints;
    JointVector all(kPalmVariables + joints.size());
    all << Vec3::Constant(bound), Vec3::Constant(bound * std::numbers::pi), joints;
    return all;
  }

  Residuals residuals(const JointVector& x) {
    robot::forward_kinematics(robot_, x.tail(posture_.size()), frames_);
    Pose moved = Pose::Identity();  // of the base, by a palm that is not where the joints put it
    Quat palm(frames_[robot_.palm_frame].linear());
    if (free_palm_) {
      const Vec3 turn = x.segment<3>(3);
      Pose goal = palm_;
      goal.translation() += x.head<3>();
      if (turn.norm() > 0)
        goal.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * palm_.linear();
      moved = goal * frames_[robot_.palm_frame].inverse(Eigen::Isometry);
      palm = Quat(goal.linear());
    }
    std::vector<Vec3> points;
    for (const int tip : held_.tips)
      points.push_back(moved * robot::tip_pose(robot_, frames_, tip).translation());
    return residuals_of(palm, points, held_);
  }

  /// Adds |residuals|² with its Gauss-Newton Hessian.
  void add_to(const JointVector& x, solve::Quadratic& model) {
    const Residuals here = residuals(x);
    Eigen::MatrixXd jacobian(here.size(), x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      JointVector beside = x;
      beside[k] += kDifference;
      jacobian.col(k) = (residuals(beside) - here) / kDifference;
    }
    model.value += here.squaredNorm();
    model.gradient.noalias() += 2 * jacobian.transpose() * here;
    model.hessian.noalias() += 2 * jacobian.transpose() * jacobian;
  }

  const robot::Robot& robot_;
  JointVector posture_;
  bool free_palm_ = false;
  Pose palm_;
  HeldTips held_;
  std::vector<Pose> frames_;
};

}  // namespace

PalmFloor palm_floor(const robot::Robot& robot, const Plan& plan) {
  std::vector<double> driven, whole_robot, hand_alone;
  if (robot.arm_centres.empty()) return {};
  for (const std::size_t k : planning::evenly_spaced_indices(plan.trajectory.samples(), kSamples)) {
    const int sample = static_cast<int>(k);
    PalmProblem by_robot(robot, plan, sample, false), by_hand(robot, plan, sample, true);
    if (!by_robot.has_goals()) continue;
    driven.push_back(by_robot.driven());
    const double by_fingers = by_hand.least_angle({});
    whole_robot.push_back(by_robot.least_angle(by_hand.best_joints));
    hand_alone.push_back(std::min(whole_robot.back(), by_fingers));
  }
  return {math::mean(driven), math::mean(whole_robot), math::mean(hand_alone)};
}

}  // namespace morphe::explain
