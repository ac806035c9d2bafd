#include "pipeline/study/hand_baselines.hpp"

#include "core/robot/forward_kinematics.hpp"

namespace morphe::study {
namespace {

constexpr double kPreviousPostureWeight = 4e-3;
constexpr double kCloseBelow_m = 0.03, kOpenAbove_m = 0.05;
constexpr double kClosedThumbDistance_m = 1e-4, kClosedFingerDistance_m = 0.03;
constexpr double kClosedWeight = 200, kClosedFingersWeight = 400;

/// A pair of points, as indices of tips; the index after the last tip is the origin.
struct TipPair {
  std::ptrdiff_t from, to;
};

/// Returns the pairs of the first tip with each other one, then the pairs of the others.
std::vector<TipPair> tip_pairs(std::ptrdiff_t tips) {
  std::vector<TipPair> pairs;
  for (std::ptrdiff_t a = 0; a < tips; ++a) {
    for (std::ptrdiff_t b = a + 1; b < tips; ++b) pairs.push_back({b, a});
  }
  return pairs;
}

double huber_loss(double x, double beta, double& slope) {
  slope = x <= beta ? x / beta : 1;
  return x <= beta ? x * x / (2 * beta) : x - beta / 2;
}

struct BaselineResidual {
  TipPair pair;
  Vec3 desired;
  double weight;
};

std::vector<BaselineResidual> baseline_residuals(BaselineMethod method, double scale,
                                                 const std::vector<Vec3>& human,
                                                 const ClosedPairs& closed) {
  const std::ptrdiff_t tips = std::ssize(human);
  std::vector<BaselineResidual> residuals;
  if (method == BaselineMethod::dexpilot) {
    const std::vector<TipPair> pairs = tip_pairs(tips);
    for (int k = 0; k < std::ssize(pairs); ++k) {
      const Vec3 h = human[pairs[k].to] - human[pairs[k].from];
      const bool thumb = k + 1 < tips;
      const double distance_m = thumb ? kClosedThumbDistance_m : kClosedFingerDistance_m;
      if (closed.closed[k])
        residuals.push_back(
            {pairs[k], distance_m * h.normalized(), thumb ? kClosedWeight : kClosedFingersWeight});
      else
        residuals.push_back({pairs[k], scale * h, 1});
    }
  }
  const double tip_weight =
      method == BaselineMethod::vector ? 1 : static_cast<double>(std::ssize(residuals) + tips);
  for (std::ptrdiff_t i = 0; i < tips; ++i)
    residuals.push_back({{tips, i}, scale * human[i], tip_weight});
  return residuals;
}

}  // namespace

void update_closed_pairs(const std::vector<Vec3>& human, ClosedPairs& state) {
  const std::vector<TipPair> pairs = tip_pairs(human.size());
  std::vector<bool>& closed = state.closed;
  closed.resize(pairs.size(), false);
  for (int k = 0; k < std::ssize(pairs); ++k) {
    const double distance = (human[pairs[k].to] - human[pairs[k].from]).norm();
    if (k + 1 < std::ssize(human)) {
      closed[k] = closed[k] ? distance <= kOpenAbove_m : distance < kCloseBelow_m;
    } else {
      const bool both = closed[pairs[k].from - 1] && closed[pairs[k].to - 1];
      closed[k] = both && distance <= kCloseBelow_m;
    }
  }
}

double baseline_objective(BaselineMethod method, const BaselineHand& hand,
                          const std::vector<Vec3>& human, const ClosedPairs& closed,
                          const JointVector& q_last, const JointVector& q, JointVector* gradient) {
  const robot::Robot& robot = hand.robot;
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, q, base_from_frame);
  const auto frame_of = [&](std::ptrdiff_t k) {
    return k < std::ssize(robot.tips) ? robot.tips[k].frame : hand.origin;
  };
  const auto point_of = [&](std::ptrdiff_t k) -> Vec3 {
    return k < std::ssize(robot.tips)
               ? Vec3(robot::tip_pose(robot, base_from_frame, k).translation())
               : Vec3(base_from_frame[hand.origin].translation());
  };
  const Eigen::Matrix3d base_from_palm = base_from_frame[robot.palm_frame].linear();
  const std::vector<BaselineResidual> residuals =
      baseline_residuals(method, hand.scale, human, closed);
  const double beta = method == BaselineMethod::vector ? 0.02 : 0.03;
  const double mean_factor = 1 / static_cast<double>(residuals.size());
  double value = kPreviousPostureWeight * (q - q_last).squaredNorm();
  if (gradient) *gradient = 2 * kPreviousPostureWeight * (q - q_last);
  for (const auto& [pair, desired, weight] : residuals) {
    const Vec3 from = point_of(pair.from), to = point_of(pair.to);
    const Vec3 error = to - from - base_from_palm * desired;
    const double norm = error.norm();
    double slope = 0;
    value += mean_factor * weight * huber_loss(norm, beta, slope);
    if (!gradient || norm == 0) continue;
    const Vec3 pull = mean_factor * weight * slope / norm * error;
    robot::add_point_gradient(robot, base_from_frame, frame_of(pair.to), -1, to, pull, *gradient);
    robot::add_point_gradient(robot, base_from_frame, frame_of(pair.from), -1, from, -pull,
                              *gradient);
  }
  return value;
}

JointRows baseline_path(BaselineMethod method, const BaselineHand& hand,
                        const std::vector<std::vector<Vec3>>& human_tips) {
  const robot::Robot& robot = hand.robot;
  JointRows path(human_tips.size(), robot.lower.size());
  JointVector q_last = 0.5 * (robot.lower + robot.upper);
  ClosedPairs closed;
  solve::MinimiseOptions options;
  options.algorithm = "slsqp";
  options.relative_tolerance = 1e-6;
  for (int f = 0; f < std::ssize(human_tips); ++f) {
    update_closed_pairs(human_tips[f], closed);
    solve::BoundedProblem problem;
    problem.lower = robot.lower;
    problem.upper = robot.upper;
    problem.objective = [&](const JointVector& q, JointVector* gradient) {
      return baseline_objective(method, hand, human_tips[f], closed, q_last, q, gradient);
    };
    const JointVector minimum = solve::minimise(problem, q_last, options).x;
    q_last = minimum;
    path.row(f) = q_last.transpose();
  }
  return path;
}

}  // namespace morphe::study
