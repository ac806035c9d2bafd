#include "pipeline/study/hand_scores.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/world.hpp"
#include "core/math/statistics.hpp"
#include "core/motion/human_motion.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::study {
namespace {

using Tips = std::vector<std::vector<Vec3>>;  // [F][tips]

Tips tips_along(const robot::Robot& robot, const JointRows& q) {
  Tips tips(q.rows());
  std::vector<Pose> poses;
  for (Eigen::Index f = 0; f < q.rows(); ++f) {
    robot::forward_kinematics(robot, q.row(f).transpose(), poses);
    for (int i = 0; i < std::ssize(robot.tips); ++i)
      tips[f].push_back(robot::tip_pose(robot, poses, i).translation());
  }
  return tips;
}

/// Computes the rms of second differences over step², where all three points are seen.
double rms_acceleration(const Tips& tips, const std::vector<double>& time) {
  double sum = 0;
  int count = 0;
  for (int f = 1; f + 1 < std::ssize(tips); ++f) {
    const double step = 0.5 * (time[f + 1] - time[f - 1]);
    for (int i = 0; i < std::ssize(tips[f]); ++i) {
      const double squared =
          (tips[f + 1][i] - 2 * tips[f][i] + tips[f - 1][i]).squaredNorm() / std::pow(step, 4);
      if (!std::isfinite(squared)) continue;
      sum += squared;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

/// Adds the overlaps of the hand with itself; only pairs that a plan checks are considered.
void score_overlaps(const robot::Robot& robot, const JointRows& q, HandScores& scores) {
  const Scene empty_scene;
  const collision::CollisionWorld world = collision::make_world(robot, empty_scene, {}, {});
  collision::CollisionScratch scratch;
  int overlapping = 0;
  for (Eigen::Index f = 0; f < q.rows(); ++f) {
    const double clearance = collision::clearance(world, q.row(f).transpose(), 0, scratch);
    overlapping += clearance < 0 ? 1 : 0;
    scores.max_overlap_m = std::max(scores.max_overlap_m, -clearance);
  }
  scores.overlap_share = overlapping / static_cast<double>(q.rows());
}

std::ptrdiff_t first_tip_of_finger(const robot::Robot& robot, int finger) {
  return std::ranges::find(robot.tips, finger, &RobotModel::Tip::finger) - robot.tips.begin();
}

}  // namespace

HandScores score_hand(const robot::Robot& robot, const HandPath& path, double pinch_distance_m) {
  HandScores scores;
  const Tips tips = tips_along(robot, path.q);
  std::vector<double> errors;
  for (int f = 0; f < std::ssize(tips); ++f) {
    for (int i = 0; i < std::ssize(tips[f]); ++i) {
      if (is_known(path.goals[f][i])) errors.push_back((tips[f][i] - path.goals[f][i]).norm());
    }
  }
  if (!errors.empty()) {
    scores.tip_mean_m = math::mean(errors);
    scores.tip_95_m = math::quantile(errors, 0.95);
  }
  const std::ptrdiff_t thumb = first_tip_of_finger(robot, kThumb),
                       index = first_tip_of_finger(robot, kIndex);
  if (std::max(thumb, index) < std::ssize(robot.tips)) {
    std::vector<double> robot_distances, human_distances, pinch_errors;
    for (int f = 0; f < std::ssize(tips); ++f) {
      const double human = (path.human[f][thumb] - path.human[f][index]).norm();
      if (std::isnan(human)) continue;
      human_distances.push_back(human);
      robot_distances.push_back((tips[f][thumb] - tips[f][index]).norm());
      if (human >= pinch_distance_m) continue;
      ++scores.pinches;
      pinch_errors.push_back(std::abs(robot_distances.back() - human));
    }
    if (scores.pinches > 0) scores.pinch_median_m = math::quantile(pinch_errors, 0.5);
    if (!human_distances.empty())
      scores.correlation = math::correlation(robot_distances, human_distances);
  }
  for (Eigen::Index f = 1; f < path.q.rows(); ++f) {
    const double step = (path.q.row(f) - path.q.row(f - 1)).cwiseAbs().maxCoeff();
    scores.max_step_rad =
        std::max(scores.max_step_rad, 0.01 * step / (path.time[f] - path.time[f - 1]));
  }
  scores.acceleration = rms_acceleration(tips, path.time) / rms_acceleration(path.goals, path.time);
  score_overlaps(robot, path.q, scores);
  return scores;
}

}  // namespace morphe::study
