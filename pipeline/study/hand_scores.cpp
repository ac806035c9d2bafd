#include "pipeline/study/hand_scores.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/world.hpp"
#include "core/math/statistics.hpp"
#include "core/motion/human_motion.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/study/correlation.hpp"

namespace morphe::study {
namespace {

using Tips = std::vector<std::vector<Vec3>>;  // [F][tips]

Tips tips_along(const robot::Robot& robot, const JointRows& q) {
  Tips tips(q.rows());
  std::vector<Pose> poses;
  for (std::size_t f = 0; f < tips.size(); ++f) {
    robot::forward_kinematics(robot, q.row(f).transpose(), poses);
    for (std::size_t i = 0; i < robot.tips.size(); ++i) {
      tips[f].push_back(robot::tip_pose(robot, poses, i).translation());
    }
  }
  return tips;
}

/// Computes the rms of second differences divided by the square of the step, over frames at which
/// all three points are seen.
double rms_acceleration(const Tips& tips, const std::vector<double>& time) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t f = 1; f + 1 < tips.size(); ++f) {
    const double step = 0.5 * (time[f + 1] - time[f - 1]);
    for (std::size_t i = 0; i < tips[f].size(); ++i) {
      const double squared =
          (tips[f + 1][i] - 2 * tips[f][i] + tips[f - 1][i]).squaredNorm() / std::pow(step, 4);
      if (!std::isfinite(squared)) continue;
      sum += squared;
      ++count;
    }
  }
  return std::sqrt(sum / static_cast<double>(count));
}

/// Adds the overlaps of the hand with itself; only pairs that a plan checks are considered.
void score_overlaps(const robot::Robot& robot, const JointRows& q, HandScores& scores) {
  const Scene nothing;
  const collision::CollisionWorld world = collision::make_world(robot, nothing, {}, {});
  collision::CollisionScratch scratch;
  Eigen::Index overlapping = 0;
  for (Eigen::Index f = 0; f < q.rows(); ++f) {
    const double clearance = collision::clearance(world, q.row(f).transpose(), 0, scratch);
    overlapping += clearance < 0 ? 1 : 0;
    scores.max_overlap_m = std::max(scores.max_overlap_m, -clearance);
  }
  scores.overlap_share = static_cast<double>(overlapping) / static_cast<double>(q.rows());
}

std::size_t first_tip_of_finger(const robot::Robot& robot, std::size_t finger) {
  const auto found = std::ranges::find(robot.tips, static_cast<int>(finger),
                                       [](const RobotModel::Tip& tip) { return tip.finger; });
  return found - robot.tips.begin();
}

}  // namespace

HandScores score_hand(const robot::Robot& robot, const HandPath& course, double near_m) {
  HandScores scores;
  const Tips tips = tips_along(robot, course.q);
  std::vector<double> errors;
  for (std::size_t f = 0; f < tips.size(); ++f) {
    for (std::size_t i = 0; i < tips[f].size(); ++i) {
      if (is_known(course.goals[f][i])) errors.push_back((tips[f][i] - course.goals[f][i]).norm());
    }
  }
  if (!errors.empty()) {
    scores.tip_mean_m = math::mean(errors);
    scores.tip_95_m = math::quantile(errors, 0.95);
  }
  const std::size_t thumb = first_tip_of_finger(robot, kThumb),
                    index = first_tip_of_finger(robot, kIndex);
  if (std::max(thumb, index) < robot.tips.size()) {
    std::vector<double> robots, humans, pinches;
    for (std::size_t f = 0; f < tips.size(); ++f) {
      const double human = (course.human[f][thumb] - course.human[f][index]).norm();
      if (std::isnan(human)) continue;
      humans.push_back(human);
      robots.push_back((tips[f][thumb] - tips[f][index]).norm());
      if (human < near_m) pinches.push_back(std::abs(robots.back() - human));
    }
    scores.pinches = pinches.size();
    if (!pinches.empty()) scores.pinch_median_m = math::quantile(pinches, 0.5);
    if (!humans.empty()) scores.correlation = correlation(robots, humans);
  }
  for (Eigen::Index f = 1; f < course.q.rows(); ++f) {
    const auto i = static_cast<std::size_t>(f);
    const double step = (course.q.row(f) - course.q.row(f - 1)).cwiseAbs().maxCoeff();
    scores.max_step_rad =
        std::max(scores.max_step_rad, 0.01 * step / (course.time[i] - course.time[i - 1]));
  }
  scores.acceleration =
      rms_acceleration(tips, course.time) / rms_acceleration(course.goals, course.time);
  score_overlaps(robot, course.q, scores);
  return scores;
}

}  // namespace morphe::study
