#include "stages/reconstruct/hand_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "pipeline/kinematics/forward.hpp"

namespace morphe {
namespace {

constexpr std::size_t kJoints = 4;  ///< of each finger
constexpr int kIterations = 60;
constexpr double kSmallStep = 1e-10;  // [rad]
/// The half-closed hand must be better than the last frame by this share to be taken instead.
constexpr double kBetter = 0.99;

using Step = Eigen::Vector4d;

/// One finger on its way to the least error.
struct Finger {
  double error = kNotSeen;  ///< of `joint`
  double damping = 1e-3;
  Step joint, trial;
  Eigen::Matrix<double, 9, 4> jacobian;
  Eigen::Matrix<double, 9, 1> rest;
  bool done = false;
};

}  // namespace

HandFit::HandFit(RobotTable hand) : hand_(std::move(hand)) {
  for (std::size_t k = 0; k < kHandAngles; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    half_closed_[k] = 0.5 * (hand_.lower[row] + hand_.upper[row]);
  }
  last_ = half_closed_;
}

HandFit::Solution HandFit::solve(const HandKeypoints& in_hand,
                                 std::array<double, kHandAngles> joint) {
  std::array<Finger, kFingers> fingers;
  JointVector q = JointVector::Zero(static_cast<Eigen::Index>(hand_.joints()));
  for (std::size_t f = 0; f < kFingers; ++f) {
    fingers[f].joint = fingers[f].trial = Eigen::Map<const Step>(&joint[kJoints * f]);
    for (std::size_t k = 1; k < 4; ++k) fingers[f].done |= !seen(in_hand[keypoint_of(f, k)]);
  }
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    for (std::size_t f = 0; f < kFingers; ++f) {
      q.segment<4>(static_cast<Eigen::Index>(kJoints * f)) = fingers[f].trial;
    }
    forward(hand_, q, frames_);
    bool all_done = true;
    for (std::size_t f = 0; f < kFingers; ++f) {
      Finger& finger = fingers[f];
      if (finger.done) continue;
      const RobotTable::Tip& tip = hand_.tips[f];
      const auto last = static_cast<std::size_t>(tip.frame);
      const auto middle = static_cast<std::size_t>(hand_.frames[last].parent);
      const Vec3 points[] = {frames_[middle].translation(), frames_[last].translation(),
                             frames_[last] * tip.transform.translation()};
      Eigen::Matrix<double, 9, 1> rest;
      for (std::size_t k = 0; k < 3; ++k) {
        rest.segment<3>(3 * static_cast<Eigen::Index>(k)) =
            in_hand[keypoint_of(f, k + 1)] - points[k];
      }
      if (const double error = rest.squaredNorm(); !(error >= finger.error)) {
        finger.error = error;
        finger.joint = finger.trial;
        finger.rest = rest;
        finger.damping = std::max(1e-12, finger.damping / 10);
        const std::size_t frame_of_point[] = {middle, last, last};
        finger.jacobian.setZero();
        for (std::size_t k = 0; k < 3; ++k) {
          Eigen::Matrix3Xd columns(3, q.size());
          point_jacobian(hand_, frames_, static_cast<int>(frame_of_point[k]), points[k], columns);
          finger.jacobian.middleRows<3>(3 * static_cast<Eigen::Index>(k)) =
              columns.middleCols<4>(static_cast<Eigen::Index>(kJoints * f));
        }
      } else {
        finger.damping *= 10;
      }
      // Joints at a limit that the error pushes further stay there.
      const auto first = static_cast<Eigen::Index>(kJoints * f);
      const Step lower = hand_.lower.segment<4>(first), upper = hand_.upper.segment<4>(first);
      Step downhill = finger.jacobian.transpose() * finger.rest;
      Eigen::Matrix4d normal = finger.jacobian.transpose() * finger.jacobian;
      normal.diagonal().array() += finger.damping * normal.trace() / 4;
      for (Eigen::Index k = 0; k < 4; ++k) {
        const bool low = finger.joint[k] <= lower[k] && downhill[k] < 0;
        const bool high = finger.joint[k] >= upper[k] && downhill[k] > 0;
        if (!low && !high) continue;
        normal.row(k).setZero();
        normal.col(k).setZero();
        normal(k, k) = 1;
        downhill[k] = 0;
      }
      finger.trial = (finger.joint + normal.ldlt().solve(downhill)).cwiseMax(lower).cwiseMin(upper);
      finger.done = !((finger.trial - finger.joint).cwiseAbs().maxCoeff() > kSmallStep);
      all_done = all_done && finger.done;
    }
    if (all_done) break;
  }
  Solution solution;
  for (std::size_t f = 0; f < kFingers; ++f) {
    solution.error[f] = fingers[f].error;
    std::copy_n(fingers[f].joint.data(), kJoints, &solution.joint[kJoints * f]);
  }
  return solution;
}

HandAngles HandFit::operator()(const HandKeypoints& in_hand) {
  const Solution from_last = solve(in_hand, last_), from_middle = solve(in_hand, half_closed_);
  HandAngles angles;
  for (std::size_t f = 0; f < kFingers; ++f) {
    const bool restart = from_middle.error[f] < kBetter * from_last.error[f];
    for (std::size_t k = kJoints * f; k < kJoints * (f + 1); ++k) {
      const bool unseen = !std::isfinite(from_last.error[f]);
      if (!unseen) last_[k] = restart ? from_middle.joint[k] : from_last.joint[k];
      angles.joint[k] = unseen ? kNotSeen : last_[k];
    }
  }
  return angles;
}

}  // namespace morphe
