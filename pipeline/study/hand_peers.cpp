#include "pipeline/study/hand_peers.hpp"

#include "core/robot/forward.hpp"

namespace morphe::study {
namespace {

constexpr double kLastWeight = 4e-3;
constexpr double kCloses_m = 0.03, kOpens_m = 0.05;
constexpr double kClosed_m = 1e-4, kClosedFingers_m = 0.03;
constexpr double kClosedWeight = 200, kClosedFingersWeight = 400;

/// Of two points: indices of tips, the origin is the one after the last.
struct TipPair {
  std::size_t from, to;
};

/// The first tip with each, then the others among each other.
std::vector<TipPair> tip_pairs(std::size_t tips) {
  std::vector<TipPair> pairs;
  for (std::size_t a = 0; a < tips; ++a) {
    for (std::size_t b = a + 1; b < tips; ++b) pairs.push_back({b, a});
  }
  return pairs;
}

double huber_of(double x, double beta, double& slope) {
  slope = x <= beta ? x / beta : 1;
  return x <= beta ? x * x / (2 * beta) : x - beta / 2;
}

struct PeerResidual {
  TipPair pair;
  Vec3 wanted;
  double weight;
};

std::vector<PeerResidual> peer_residuals(PeerMethod method, double scale,
                                         const std::vector<Vec3>& human,
                                         const ClosedPairs& closed) {
  const std::size_t tips = human.size();
  std::vector<PeerResidual> all;
  if (method == PeerMethod::dexpilot) {
    const std::vector<TipPair> pairs = tip_pairs(tips);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Vec3 h = human[pairs[k].to] - human[pairs[k].from];
      const bool thumb = k + 1 < tips;
      if (closed.closed[k]) {
        all.push_back({pairs[k], (thumb ? kClosed_m : kClosedFingers_m) * h.normalized(),
                       thumb ? kClosedWeight : kClosedFingersWeight});
      } else {
        all.push_back({pairs[k], scale * h, 1});
      }
    }
  }
  const double to_tips = method == PeerMethod::vector ? 1 : static_cast<double>(all.size() + tips);
  for (std::size_t i = 0; i < tips; ++i) all.push_back({{tips, i}, scale * human[i], to_tips});
  return all;
}

}  // namespace

void update_closed(const std::vector<Vec3>& human, ClosedPairs& state) {
  const std::vector<TipPair> pairs = tip_pairs(human.size());
  std::vector<bool>& closed = state.closed;
  closed.resize(pairs.size(), false);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double distance = (human[pairs[k].to] - human[pairs[k].from]).norm();
    if (k + 1 < human.size()) {
      closed[k] = closed[k] ? distance <= kOpens_m : distance < kCloses_m;
    } else {
      const bool both = closed[pairs[k].from - 1] && closed[pairs[k].to - 1];
      closed[k] = both && distance <= kCloses_m;
    }
  }
}

double peer_objective(PeerMethod method, const PeerHand& hand, const std::vector<Vec3>& human,
                      const ClosedPairs& closed, const JointVector& last, const JointVector& q,
                      JointVector* gradient) {
  const robot::Robot& robot = hand.robot;
  std::vector<Pose> base_from_frame;
  robot::forward(robot, q, base_from_frame);
  const auto frame_of = [&](std::size_t k) {
    return k < robot.tips.size() ? robot.tips[k].frame : hand.origin;
  };
  const auto point_of = [&](std::size_t k) -> Vec3 {
    return k < robot.tips.size()
               ? Vec3(robot::tip_pose(robot, base_from_frame, k).translation())
               : Vec3(base_from_frame[static_cast<std::size_t>(hand.origin)].translation());
  };
  const Eigen::Matrix3d base_from_palm =
      base_from_frame[static_cast<std::size_t>(robot.palm_frame)].linear();
  const std::vector<PeerResidual> all = peer_residuals(method, hand.scale, human, closed);
  const double beta = method == PeerMethod::vector ? 0.02 : 0.03;
  const double share = 1 / static_cast<double>(all.size());
  double value = kLastWeight * (q - last).squaredNorm();
  if (gradient) *gradient = 2 * kLastWeight * (q - last);
  for (const PeerResidual& r : all) {
    const Vec3 from = point_of(r.pair.from), to = point_of(r.pair.to);
    const Vec3 off = to - from - base_from_palm * r.wanted;
    const double norm = off.norm();
    double slope = 0;
    value += share * r.weight * huber_of(norm, beta, slope);
    if (!gradient || norm == 0) continue;
    const Vec3 pull = share * r.weight * slope / norm * off;
    robot::add_point_slope(robot, base_from_frame, frame_of(r.pair.to), -1, to, pull, *gradient);
    robot::add_point_slope(robot, base_from_frame, frame_of(r.pair.from), -1, from, -pull,
                           *gradient);
  }
  return value;
}

JointRows peer_course(PeerMethod method, const PeerHand& hand,
                      const std::vector<std::vector<Vec3>>& human_tips) {
  const robot::Robot& robot = hand.robot;
  JointRows course(static_cast<Eigen::Index>(human_tips.size()), robot.lower.size());
  JointVector last = 0.5 * (robot.lower + robot.upper);
  ClosedPairs closed;
  solve::MinimiseOptions options;
  options.algorithm = "slsqp";
  options.relative_value = 1e-6;
  for (std::size_t f = 0; f < human_tips.size(); ++f) {
    update_closed(human_tips[f], closed);
    solve::BoundedProblem problem;
    problem.lower = robot.lower;
    problem.upper = robot.upper;
    problem.objective = [&](const JointVector& q, JointVector* gradient) {
      return peer_objective(method, hand, human_tips[f], closed, last, q, gradient);
    };
    const JointVector found = solve::minimise(problem, last, options).x;
    last = found;
    course.row(static_cast<Eigen::Index>(f)) = last.transpose();
  }
  return course;
}

}  // namespace morphe::study
