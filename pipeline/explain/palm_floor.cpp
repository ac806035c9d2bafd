#include "pipeline/explain/palm_floor.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/humanlike/arm_posture.hpp"
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

/// The tips that must stay, and the goals of palm and arm, at one sample.
struct HeldTips {
  std::vector<int> tips;
  std::vector<Vec3> places;
  Quat hand = unknown_rotation();
  humanlike::ArmPoints arm;
};

/// The tips' distances from their places, the differences of the directions of upper arm and
/// forearm if they count, and the palm's rotation from the hand.
using Residuals = Eigen::VectorXd;

Residuals residuals_of(const Quat& palm, const std::vector<Vec3>& points, const HeldTips& held) {
  Residuals out(3 * std::ssize(points) + 3);
  for (Eigen::Index i = 0; i < std::ssize(points); ++i)
    out.segment<3>(3 * i) = (points[i] - held.places[i]) / kTipScale_m;
  const Eigen::AngleAxisd turn(held.hand.conjugate() * palm);
  out.tail<3>() = turn.angle() * turn.axis();
  return out;
}

/// Returns the difference of the directions of two vectors, about their angle if it is small.
Vec3 chord(const Vec3& a, const Vec3& b) { return a.normalized() - b.normalized(); }

/// The variables of a sample's problem and its goals.
enum class PalmSearch {
  free_palm,  ///< the palm's shift and turn from its driven pose, then all joints; the palm's angle
  joints,     ///< all joints; the palm's angle
  whole_arm   ///< all joints; the palm's angle and the links' directions
};

/// One sample's problem.
class PalmProblem {
 public:
  PalmProblem(const robot::Robot& robot, const Plan& plan, int sample, PalmSearch search)
      : robot_(robot), posture_(plan.trajectory.position.row(sample).transpose()) {
    free_palm_ = search == PalmSearch::free_palm;
    whole_arm_ = search == PalmSearch::whole_arm;
    robot::forward_kinematics(robot, posture_, frames_);
    palm_ = frames_[robot.palm_frame];
    const double time_s = plan.trajectory.demonstration_time[sample];
    held_.hand = wrist_orientation_at(plan.goals, time_s);
    held_.arm = humanlike::arm_points(plan.goals, time_s);
    for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
      if (robot.tips[tip].finger < 0 || !is_known(tip_goal_at(plan.goals, tip, time_s))) continue;
      held_.tips.push_back(tip);
      held_.places.push_back(robot::tip_pose(robot, frames_, tip).translation());
    }
  }

  bool has_goals() const { return is_known(held_.hand) && !held_.tips.empty(); }
  bool has_arm() const {
    return is_known(held_.arm.elbow) && is_known(held_.arm.wrist) && is_known(held_.arm.shoulder) &&
           is_known(humanlike::arm_points(robot_, frames_).elbow);
  }
  double driven() const { return angle_between(Quat(palm_.linear()), held_.hand); }

  /// Returns the least angle that local searches find, of those that keep the tips in their places:
  /// from the driven posture, and from it with the palm turned to the hand, or with other fingers.
  double least_angle(const JointVector& other_fingers) {
    double least = driven();
    for (const JointVector& start : {with_palm(posture_, 0), other_start(other_fingers)}) {
      const JointVector x = minimum_from(start);
      const Residuals found = residuals(x);
      if (!holds_tips(found)) continue;
      if (found.tail<3>().norm() >= least) continue;
      least = found.tail<3>().norm();
      best_joints = x.tail(posture_.size());
    }
    return least;
  }

  /// Returns the angles of the posture with the least sum of squares that searches from the driven
  /// one, with its fingers or other ones, find.
  WholeArmFloor least_angles(const JointVector& other_fingers) {
    JointVector best = posture_;
    double least = residuals(posture_).squaredNorm();
    for (const JointVector& start : {posture_, other_start(other_fingers)}) {
      const JointVector x = minimum_from(start);
      const Residuals found = residuals(x);
      if (!holds_tips(found) || found.squaredNorm() >= least) continue;
      least = found.squaredNorm();
      best = x;
    }
    robot::forward_kinematics(robot_, best, frames_);
    const humanlike::ArmPoints arm = humanlike::arm_points(robot_, frames_);
    const humanlike::ArmPoints& human = held_.arm;
    return {humanlike::direction_error(arm.elbow - arm.shoulder, human.elbow - human.shoulder),
            humanlike::direction_error(arm.wrist - arm.elbow, human.wrist - human.elbow),
            angle_between(Quat(frames_[robot_.palm_frame].linear()), held_.hand)};
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

  bool holds_tips(const Residuals& found) const {
    return kTipScale_m * found.head(3 * std::ssize(held_.tips)).cwiseAbs().maxCoeff() <=
           kMaxTipError_m;
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
    const Residuals of_palm = residuals_of(palm, points, held_);
    if (!whole_arm_) return of_palm;
    const humanlike::ArmPoints arm = humanlike::arm_points(robot_, frames_);
    Residuals all(of_palm.size() + 6);
    all << of_palm.head(of_palm.size() - 3),
        chord(arm.elbow - arm.shoulder, held_.arm.elbow - held_.arm.shoulder),
        chord(arm.wrist - arm.elbow, held_.arm.wrist - held_.arm.elbow), of_palm.tail<3>();
    return all;
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
  bool free_palm_ = false, whole_arm_ = false;
  Pose palm_;
  HeldTips held_;
  std::vector<Pose> frames_;
};

}  // namespace

PalmFloor palm_floor(const robot::Robot& robot, const Plan& plan) {
  std::vector<double> driven, whole_robot, hand_alone, upper_arm, forearm, palm;
  if (robot.arm_centres.empty()) return {};
  for (const std::size_t k : planning::evenly_spaced_indices(plan.trajectory.samples(), kSamples)) {
    const int sample = static_cast<int>(k);
    PalmProblem by_robot(robot, plan, sample, PalmSearch::joints),
        by_hand(robot, plan, sample, PalmSearch::free_palm),
        by_arm(robot, plan, sample, PalmSearch::whole_arm);
    if (!by_robot.has_goals()) continue;
    driven.push_back(by_robot.driven());
    const double by_fingers = by_hand.least_angle({});
    whole_robot.push_back(by_robot.least_angle(by_hand.best_joints));
    hand_alone.push_back(std::min(whole_robot.back(), by_fingers));
    if (!by_arm.has_arm()) continue;
    const WholeArmFloor floor = by_arm.least_angles(by_hand.best_joints);
    upper_arm.push_back(floor.upper_arm);
    forearm.push_back(floor.forearm);
    palm.push_back(floor.palm);
  }
  return {math::mean(driven),
          math::mean(whole_robot),
          math::mean(hand_alone),
          {math::mean(upper_arm), math::mean(forearm), math::mean(palm)}};
}

}  // namespace morphe::explain
