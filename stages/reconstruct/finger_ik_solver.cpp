#include "stages/reconstruct/finger_ik_solver.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::reconstruct {
namespace {

constexpr int kMaxIterations = 60, kMaxInitialSolves = 50;
constexpr double kStepTolerance_rad = 1e-8;
constexpr double kPosturePrior_m_per_rad = 0.005;  ///< weight of the change of an angle

/// Returns true if all points of a finger beyond its base are seen.
bool is_finger_seen(const HandKeypoints& points, std::size_t finger) {
  return is_known(points[keypoint_index(finger, 1)]) &&
         is_known(points[keypoint_index(finger, 2)]) && is_known(points[keypoint_index(finger, 3)]);
}

}  // namespace

struct FingerIkSolver::FingerSolve {
  Angles lower, upper, joint, trial;
  double error = kUnknown;  ///< of `joint`; NaN before the first evaluation
  double damping = 1e-3;
  Eigen::Matrix<double, 9, 4> jacobian = Eigen::Matrix<double, 9, 4>::Zero();
  Eigen::Matrix<double, 9, 1> residual;
  bool done = false;

  /// Computes the next trial. Joints at a limit stay there if the error pushes them beyond it.
  void step(const Angles& last) {
    Angles downhill = jacobian.transpose() * residual +
                      kPosturePrior_m_per_rad * kPosturePrior_m_per_rad * (last - joint);
    Eigen::Matrix4d normal = jacobian.transpose() * jacobian;
    normal.diagonal().array() +=
        kPosturePrior_m_per_rad * kPosturePrior_m_per_rad + damping * normal.trace() / 4;
    for (Eigen::Index k = 0; k < 4; ++k) {
      const bool low = joint[k] <= lower[k] && downhill[k] < 0;
      const bool high = joint[k] >= upper[k] && downhill[k] > 0;
      if (!low && !high) continue;
      normal.row(k).setZero();
      normal.col(k).setZero();
      normal(k, k) = 1;
      downhill[k] = 0;
    }
    trial = (joint + normal.ldlt().solve(downhill)).cwiseMax(lower).cwiseMin(upper);
    done = !((trial - joint).cwiseAbs().maxCoeff() > kStepTolerance_rad);
  }
};

FingerIkSolver::FingerIkSolver(RobotModel hand, double max_step_rad)
    : hand_(std::move(hand)), max_step_rad_(max_step_rad) {
  for (int frame = 0; frame < std::ssize(hand_.frames); ++frame) {
    const int joint = hand_.frames[frame].joint;
    if (joint < 0 || joint / kJoints >= std::ssize(fingers_)) continue;
    fingers_[joint / kJoints].frames[joint % kJoints] = frame;
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    fingers_[f].lower = hand_.lower.segment<4>(kJoints * f);
    fingers_[f].upper = hand_.upper.segment<4>(kJoints * f);
    fingers_[f].tip_in_last = hand_.tips[f].transform.translation();
  }
}

void FingerIkSolver::prepare(const HandKeypoints& in_hand,
                             std::array<FingerSolve, kFingerCount>& tasks) const {
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Finger& finger = fingers_[f];
    const double bound = finger.was_seen ? max_step_rad_ : std::numeric_limits<double>::infinity();
    tasks[f].lower = finger.lower.cwiseMax((finger.last.array() - bound).matrix());
    tasks[f].upper = finger.upper.cwiseMin((finger.last.array() + bound).matrix());
    tasks[f].joint = tasks[f].trial = finger.last;
    tasks[f].done = !is_finger_seen(in_hand, f);
  }
}

void FingerIkSolver::minimise(const HandKeypoints& in_hand,
                              std::array<FingerSolve, kFingerCount>& tasks) {
  JointVector q = JointVector::Zero(hand_.joints());
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    if (std::ranges::all_of(tasks, [](const FingerSolve& task) { return task.done; })) return;
    for (std::size_t f = 0; f < kFingerCount; ++f) q.segment<4>(kJoints * f) = tasks[f].trial;
    robot::forward_kinematics(hand_, q, frames_);
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      FingerSolve& task = tasks[f];
      if (task.done) continue;
      const Finger& finger = fingers_[f];
      const Vec3 points[] = {frames_[finger.frames[2]].translation(),
                             frames_[finger.frames[3]].translation(),
                             frames_[finger.frames[3]] * finger.tip_in_last};
      Eigen::Matrix<double, 9, 1> residual;
      for (int k = 0; k < 3; ++k) {
        residual.segment<3>(3 * k) = in_hand[keypoint_index(f, k + 1)] - points[k];
      }
      const double error = residual.squaredNorm() + kPosturePrior_m_per_rad *
                                                        kPosturePrior_m_per_rad *
                                                        (task.trial - finger.last).squaredNorm();
      if (!(error >= task.error)) {  // also if task.error is NaN
        task.error = error;
        task.joint = task.trial;
        task.residual = residual;
        task.damping = std::max(1e-12, task.damping / 10);
        for (int j = 0; j < 4; ++j) {
          const Pose& pose = frames_[finger.frames[j]];
          const Vec3 axis = pose.linear() * hand_.frames[finger.frames[j]].axis;
          for (int k = std::max(0, j - 1); k < 3; ++k) {
            task.jacobian.block<3, 1>(3 * k, j) = axis.cross(points[k] - pose.translation());
          }
        }
      } else {
        task.damping *= 10;
      }
      task.step(finger.last);
    }
  }
}

human::HandAngles FingerIkSolver::operator()(const HandKeypoints& in_hand) {
  bool any_unsolved = false;
  for (Finger& finger : fingers_) {
    if (!finger.was_seen) finger.last = 0.5 * (finger.lower + finger.upper);
    any_unsolved = any_unsolved || !finger.was_seen;
  }
  human::HandAngles angles;
  for (int round = 0; round < (any_unsolved ? kMaxInitialSolves : 1); ++round) {
    std::array<FingerSolve, kFingerCount> tasks;
    prepare(in_hand, tasks);
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      tasks[f].done = tasks[f].done || (round > 0 && fingers_[f].was_seen);
    }
    minimise(in_hand, tasks);
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      if (std::isfinite(tasks[f].error)) fingers_[f].last = tasks[f].joint;
    }
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    fingers_[f].was_seen = is_finger_seen(in_hand, f);
    for (int k = 0; k < kJoints; ++k) {
      angles.joint[kJoints * f + k] = fingers_[f].was_seen ? fingers_[f].last[k] : kUnknown;
    }
  }
  return angles;
}

}  // namespace morphe::reconstruct
