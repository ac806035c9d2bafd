#include "stages/certify/trajectory_motion.hpp"

#include <algorithm>
#include <memory>

#include "core/math/quintic.hpp"

namespace morphe::certify {
namespace {

/// Returns [samples, n] how far each joint would travel up to each sample if it moved at the
/// largest speed of every quintic.
JointRows max_travel(const Trajectory& trajectory) {
  JointRows travel = JointRows::Zero(trajectory.position.rows(), trajectory.position.cols());
  for (int i = 0; i + 1 < std::ssize(trajectory.time); ++i) {
    for (Eigen::Index joint = 0; joint < travel.cols(); ++joint) {
      const math::QuinticPiece piece = math::quintic_piece(trajectory, i, joint);
      const math::Range speed = math::extremes(piece).velocity;
      travel(i + 1, joint) =
          travel(i, joint) + std::max(-speed.least, speed.greatest) * piece.duration;
    }
  }
  return travel;
}

/// Returns the fraction of the interval from `sample` to `sample` + 1 at a time.
double share_of(const Trajectory& trajectory, std::size_t sample, double time_s) {
  const double share =
      (time_s - trajectory.time[sample]) / (trajectory.time[sample + 1] - trajectory.time[sample]);
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace

std::size_t sample_before(const Trajectory& trajectory, double time_s) {
  const auto after = std::ranges::upper_bound(trajectory.time, time_s) - trajectory.time.begin();
  return std::max<std::ptrdiff_t>(0, std::min(after - 1, std::ssize(trajectory.time) - 2));
}

collision::JointMotion trajectory_motion(const Trajectory& trajectory) {
  collision::JointMotion motion;
  motion.begin = trajectory.time.front();
  motion.end = trajectory.time.back();
  motion.position = [&trajectory](double s, JointVector& q) {
    const std::size_t i = sample_before(trajectory, s);
    q.resize(trajectory.position.cols());
    for (Eigen::Index joint = 0; joint < q.size(); ++joint) {
      q[joint] = math::value_at(math::quintic_piece(trajectory, i, joint), s - trajectory.time[i]);
    }
  };
  const auto max_travel_at = std::make_shared<const JointRows>(max_travel(trajectory));
  motion.travel = [&trajectory, max_travel_at](double s0, double s1, JointVector& travel) {
    const auto travel_at = [&](double s) -> Eigen::RowVectorXd {
      const std::size_t i = sample_before(trajectory, s);
      const double share = share_of(trajectory, i, s);
      return (1 - share) * max_travel_at->row(i) + share * max_travel_at->row(i + 1);
    };
    const Eigen::RowVectorXd middle = travel_at(0.5 * (s0 + s1));
    travel = (middle - travel_at(s0)).cwiseMax(travel_at(s1) - middle).transpose();
  };
  motion.demonstration_time = [&trajectory](double s) {
    const std::size_t i = sample_before(trajectory, s);
    const double share = share_of(trajectory, i, s);
    const std::vector<double>& time_s = trajectory.demonstration_time;
    return (1 - share) * time_s[i] + share * time_s[i + 1];
  };
  return motion;
}

}  // namespace morphe::certify
