#include "stages/certify/trajectory_motion.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/math/quintic.hpp"

namespace morphe::certify {
namespace {

/// Returns way(i, j), the greatest distance that joint j can have travelled up to sample i at each
/// piece's largest speed [rad].
JointRows max_travel(const Trajectory& trajectory) {
  JointRows way = JointRows::Zero(trajectory.position.rows(), trajectory.position.cols());
  for (std::size_t i = 0; i + 1 < trajectory.samples(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (Eigen::Index joint = 0; joint < way.cols(); ++joint) {
      const math::QuinticPiece piece = math::quintic_piece(trajectory, i, joint);
      const math::Range speed = math::extremes(piece).velocity;
      way(row + 1, joint) =
          way(row, joint) + std::max(-speed.least, speed.greatest) * piece.duration;
    }
  }
  return way;
}

/// Returns the fraction of the interval from `sample` to `sample` + 1 at a time.
double share_of(const Trajectory& trajectory, std::size_t sample, double time_s) {
  const double share =
      (time_s - trajectory.time[sample]) / (trajectory.time[sample + 1] - trajectory.time[sample]);
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace

std::size_t sample_before(const Trajectory& trajectory, double time_s) {
  const auto after = std::upper_bound(trajectory.time.begin(), trajectory.time.end(), time_s);
  const auto index = static_cast<std::size_t>(after - trajectory.time.begin());
  return std::min(index == 0 ? 0 : index - 1, trajectory.samples() - 2);
}

double demonstration_time_at(const Trajectory& trajectory, double time_s) {
  const std::size_t i = sample_before(trajectory, time_s);
  const double share = share_of(trajectory, i, time_s);
  return (1 - share) * trajectory.demonstration_time[i] +
         share * trajectory.demonstration_time[i + 1];
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
  const auto way = std::make_shared<const JointRows>(max_travel(trajectory));
  motion.travel = [&trajectory, way](double s0, double s1, JointVector& travel) {
    const auto way_at = [&](double s) -> Eigen::RowVectorXd {
      const std::size_t i = sample_before(trajectory, s);
      const double share = share_of(trajectory, i, s);
      const auto row = static_cast<Eigen::Index>(i);
      return (1 - share) * way->row(row) + share * way->row(row + 1);
    };
    const Eigen::RowVectorXd middle = way_at(0.5 * (s0 + s1));
    travel = (middle - way_at(s0)).cwiseMax(way_at(s1) - middle).transpose();
  };
  motion.demonstration_time = [&trajectory](double s) {
    return demonstration_time_at(trajectory, s);
  };
  return motion;
}

}  // namespace morphe::certify
