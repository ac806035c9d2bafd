#include "stages/retime/fit_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/banded.hpp"
#include "core/math/quintic.hpp"
#include "core/robot/forward.hpp"
#include "core/robot/tree.hpp"
#include "stages/retime/inside_limits.hpp"

namespace morphe::retime {
namespace {

constexpr int kRounds = 30,
              kPatience = 6;  ///< then roughness counts for less where it is in the way
constexpr int kHalvings = 2;
constexpr double kLessRoughness = 0.5;
constexpr double kEndWeight = 1e5;         ///< the path's ends are kept
constexpr double kMostWeight = 1e8;        ///< beyond it rounding wins
constexpr double kLimitWeight = 100;       ///< of what is pulled onto a joint limit, times what …
constexpr double kMostLimitWeight = 1e10;  ///< … the samples around weigh
constexpr double kLeastRoughness = 1e-8, kMostRoughness = 1e6;  ///< what doubles can tell apart
constexpr double kLinear = 0.98;  ///< of the tip tolerance: a Jacobian is not the whole truth
constexpr double kExactDuration_s = 0.003, kExact = 1e-5;

/// Tips' positions per joint at each sample, and the joints that no tip depends on.
struct Leverage {
  std::vector<Eigen::MatrixXd> jacobian;  ///< [W] of [3 m, n]
  Eigen::ArrayXd bare;                    ///< [n] 1: moves no tip, 0
};

Leverage leverage_of(const RobotTable& robot, const JointRows& samples) {
  Leverage out;
  const Eigen::Index n = samples.cols();
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  out.bare = Eigen::ArrayXd::Ones(n);
  if (tips == 0) return out;
  for (const RobotTable::Tip& tip : robot.tips) {
    for (const int frame : robot::upwards(robot, tip.frame)) {
      const int joint = robot::joint_of(robot, frame);
      if (joint >= 0) out.bare[joint] = 0;
    }
  }
  std::vector<Pose> base_from_frame;
  Eigen::MatrixXd both(6 * tips, n);
  for (Eigen::Index i = 0; i < samples.rows(); ++i) {
    const JointVector q = samples.row(i).transpose();
    robot::forward(robot, q, base_from_frame);
    robot::tip_jacobians(robot, base_from_frame, both);
    Eigen::MatrixXd& points = out.jacobian.emplace_back(3 * tips, n);
    for (Eigen::Index t = 0; t < tips; ++t) {
      points.middleRows<3>(3 * t) = both.middleRows<3>(6 * t);
    }
  }
  return out;
}

struct Deviation {
  double tip = 0, bare = 0, any = 0;
};
Deviation deviation_at(const Leverage& leverage, std::size_t i, const JointVector& off) {
  Deviation out;
  out.any = off.cwiseAbs().maxCoeff();
  out.bare = (off.array().abs() * leverage.bare).maxCoeff();
  if (leverage.jacobian.empty()) return out;
  const Eigen::VectorXd moved = leverage.jacobian[i] * off;
  for (Eigen::Index t = 0; t < moved.size(); t += 3) {
    out.tip = std::max(out.tip, moved.segment<3>(t).norm());
  }
  return out;
}

/// Where the samples lie among the knots, and what they weigh; the same for all joints.
struct Rows {
  std::vector<math::SplinePoint> place;
  std::vector<Eigen::Matrix<double, 6, 1>> basis;
  std::vector<double> weight;
  Eigen::VectorXd roughness;     ///< weight of each third difference
  Eigen::VectorXd limit_weight;  ///< of what is pulled onto a limit, for each interval
};

Rows rows_of(const std::vector<double>& clock, const std::vector<double>& allowance,
             double duration_s, const math::JointSpline& spline) {
  Rows rows;
  rows.roughness = Eigen::VectorXd::Constant(spline.coefficient.rows() - 3, kLeastRoughness);
  for (std::size_t i = 0; i < clock.size(); ++i) {
    const math::SplinePoint at = math::spline_point(spline, clock[i]);
    rows.place.push_back(at);
    const auto basis = math::bspline_weights<5>(at.z);
    rows.basis.emplace_back(basis.data());
    const double roughness =
        std::min(kMostRoughness, std::pow(allowance[i] * duration_s / spline.step(), 6));
    for (Eigen::Index k = 0; k < 3; ++k) {
      double& here = rows.roughness[at.interval + k];
      here = std::max(here, roughness);
    }
    const double before = i > 0 ? clock[i] - clock[i - 1] : 0;
    const double after = i + 1 < clock.size() ? clock[i + 1] - clock[i] : 0;
    rows.weight.push_back(std::max(0.02, 0.5 * (before + after) / spline.step()));
  }
  rows.weight.front() = rows.weight.back() = kEndWeight;
  return rows;
}

/// A sample's weight is at least a tenth of its neighbours': one alone would only make the curve
/// swing around it. The ends keep theirs.
void spread(std::vector<double>& weight) {
  constexpr double kShare = 0.1;
  for (std::size_t i = 2; i + 1 < weight.size(); ++i) {
    weight[i] = std::max(weight[i], kShare * weight[i - 1]);
  }
  for (std::size_t i = weight.size() - 2; i-- > 1;) {
    weight[i] = std::max(weight[i], kShare * weight[i + 1]);
  }
}

/// Firmer than the samples whose coefficients an interval shares.
void weigh_limits(Rows& rows) {
  const Eigen::Index intervals = rows.roughness.size() - 2;
  rows.limit_weight = Eigen::VectorXd::Constant(intervals, 10);
  for (std::size_t i = 0; i < rows.weight.size(); ++i) {
    const Eigen::Index first = std::max<Eigen::Index>(0, rows.place[i].interval - 5);
    const Eigen::Index last = std::min(intervals - 1, rows.place[i].interval + 5);
    for (Eigen::Index k = first; k <= last; ++k) {
      rows.limit_weight[k] = std::max(rows.limit_weight[k], rows.weight[i]);
    }
  }
  rows.limit_weight = (kLimitWeight * rows.limit_weight).cwiseMin(kMostLimitWeight);
}

/// The normal equations' matrix without pulls.
math::BandedMatrix normal_of(const Rows& rows) {
  math::BandedMatrix normal(rows.roughness.size() + 3, 5);
  for (std::size_t i = 0; i < rows.weight.size(); ++i) {
    add_form(normal, rows.place[i].interval, rows.weight[i], rows.basis[i].data());
  }
  constexpr std::array<double, 4> third{-1, 3, -3, 1};
  for (Eigen::Index i = 0; i < rows.roughness.size(); ++i) {
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        normal.entry(i + static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(a - b)) +=
            rows.roughness[i] * third[a] * third[b];
      }
    }
  }
  return normal;
}

void solve(Rows& rows, const JointRows& offset, const JointVector& lower, const JointVector& upper,
           std::vector<LimitPull>& pulls, JointRows& coefficient) {
  coefficient.setZero();
  for (std::size_t i = 0; i < rows.weight.size(); ++i) {
    for (Eigen::Index a = 0; a < 6; ++a) {
      coefficient.row(rows.place[i].interval + a) +=
          (rows.weight[i] * rows.basis[i][a]) * offset.row(static_cast<Eigen::Index>(i));
    }
  }
  const JointRows right = coefficient;
  const math::BandedMatrix free = normal_of(rows);
  math::solve_factored(factored(free), coefficient);
  for (std::size_t joint = 0; joint < pulls.size(); ++joint) {
    const auto column = static_cast<Eigen::Index>(joint);
    Eigen::VectorXd c = coefficient.col(column);
    // The curve lies between its coefficients, too.
    const bool inside = c.minCoeff() >= lower[column] && c.maxCoeff() <= upper[column];
    if (inside && pulls[joint].side.size() == 0) continue;
    if (rows.limit_weight.size() == 0) weigh_limits(rows);
    solve_inside({free, right.col(column), rows.limit_weight, lower[column], upper[column]},
                 pulls[joint], c);
    coefficient.col(column) = c;
  }
}

/// One fit on given knots; the largest excess over the tolerance, <= 1: it holds.
double fit(const RobotTable& robot, const std::vector<double>& clock, const JointRows& samples,
           const std::vector<double>& allowance, const FitTolerance& tolerance,
           const Leverage& leverage, PathFit& out) {
  Rows rows = rows_of(clock, allowance, tolerance.duration_s, out.spline);
  // Offsets from the first sample: damping must not move a constant.
  const Eigen::RowVectorXd origin =
      samples.row(0).cwiseMax(robot.lower.transpose()).cwiseMin(robot.upper.transpose());
  const JointRows offset = samples.rowwise() - origin;
  const Eigen::Index n = samples.cols();
  const JointVector inset = (0.25 * (robot.upper - robot.lower)).cwiseMin(kLimitInset);
  const JointVector lower = robot.lower + inset - origin.transpose();
  const JointVector upper = robot.upper - inset - origin.transpose();
  std::vector<LimitPull> pulls(static_cast<std::size_t>(n));
  JointRows& coefficient = out.spline.coefficient;
  double excess = 0;
  for (int round = 0; round < kRounds; ++round) {
    rows.limit_weight.resize(0);
    solve(rows, offset, lower, upper, pulls, coefficient);
    bool settled = true;
    excess = out.tip_deviation = out.joint_deviation = 0;
    for (std::size_t i = 0; i < clock.size(); ++i) {
      const JointVector off =
          coefficient.middleRows<6>(rows.place[i].interval).transpose() * rows.basis[i] -
          offset.row(static_cast<Eigen::Index>(i)).transpose();
      const Deviation here = deviation_at(leverage, i, off);
      out.tip_deviation = std::max(out.tip_deviation, here.tip);
      out.joint_deviation = std::max(out.joint_deviation, here.any);
      const double share =
          std::max(here.tip / (kLinear * tolerance.tip_m), here.bare / tolerance.joint_rad) /
          allowance[i];
      excess = std::max(excess, share);
      if (share <= 1 || rows.weight[i] > kMostWeight) continue;
      rows.weight[i] *= std::clamp(share * share, 2.0, 100.0);
      if (round >= kPatience) {
        rows.roughness.segment<3>(rows.place[i].interval) *= kLessRoughness;
      }
      settled = false;
    }
    if (settled) break;
    spread(rows.weight);
  }
  out.spline.origin = origin;
  return excess;
}

/// Whether a joint's curve is inside its limits between the knots `from` and `to`: each interval is
/// the quintic that meets its two ends.
bool stays_inside(const math::JointSpline& spline, Eigen::Index joint, Eigen::Index from,
                  Eigen::Index to, double lower, double upper) {
  JointRows at;
  const auto state_at = [&](Eigen::Index knot) {
    math::evaluate(spline, spline.step() * static_cast<double>(knot), at);
    return math::JointState{at(0, joint), at(1, joint), at(2, joint)};
  };
  math::JointState begin = state_at(from);
  for (Eigen::Index knot = from + 1; knot <= to; ++knot) {
    const math::JointState end = state_at(knot);
    if (math::beyond(math::quintic_piece(begin, end, spline.step()), lower, upper) > 0)
      return false;
    begin = end;
  }
  return true;
}

/// Coefficients with the rest of a missed end added there; it fades out over `fade` knots.
Eigen::VectorXd with_end(Eigen::VectorXd coefficient, double missing, bool first, Eigen::Index flat,
                         Eigen::Index fade) {
  for (Eigen::Index k = 0; k < flat + fade; ++k) {
    const double along = static_cast<double>(std::max<Eigen::Index>(0, k - flat + 1)) /
                         static_cast<double>(fade + 1);
    const double share = 1 - along * along * along * (10 + along * (6 * along - 15));
    coefficient[first ? k : coefficient.size() - 1 - k] += share * missing;
  }
  return coefficient;
}

/// Where an end was missed for all its weight, the rest is added to the coefficients there and
/// fades out over some knots, over fewer where that would leave a joint's limits; where these leave
/// them, too, what rests at the end stays there for a moment and the coefficients keep inside; not
/// where that would change much.
void meet_ends(const RobotTable& robot, const JointRows& samples, math::JointSpline& spline) {
  constexpr Eigen::Index kFlat = 5, kFade = 25;  // a knot's value is the mean of five coefficients
  constexpr Eigen::Index kShortest = 5;
  constexpr double kRest = 1e-4;  // nearer to the end: as good as at rest [rad]
  const Eigen::Index count = spline.coefficient.rows();
  const Eigen::Index longest = std::min(kFade, count / 2 - kFlat);
  if (longest < 1) return;
  JointRows there;
  for (const bool first : {true, false}) {
    math::evaluate(spline, first ? 0 : spline.length, there);
    const Eigen::RowVectorXd missing = samples.row(first ? 0 : samples.rows() - 1) - there.row(0);
    const Eigen::Index reach = std::min(spline.intervals, kFlat + longest);
    const Eigen::Index from = first ? 0 : spline.intervals - reach;
    for (Eigen::Index joint = 0; joint < missing.size(); ++joint) {
      if (std::abs(missing[joint]) <= 2 * kLimitInset) continue;
      const double lower = robot.lower[joint] + 0.5 * kLimitInset,
                   upper = robot.upper[joint] - 0.5 * kLimitInset;
      const auto inside = [&] {
        return stays_inside(spline, joint, from, from + reach, lower, upper);
      };
      const Eigen::VectorXd before = spline.coefficient.col(joint);
      const auto fading = [&](Eigen::Index fade) {
        spline.coefficient.col(joint) = with_end(before, missing[joint], first, kFlat, fade);
      };
      Eigen::Index fade = longest;
      fading(fade);
      while (!inside() && fade / 2 >= kShortest) fading(fade /= 2);
      if (inside()) continue;
      fading(longest);
      for (Eigen::Index k = 0; k < kFlat + longest; ++k) {
        double& c = spline.coefficient(first ? k : count - 1 - k, joint);
        const double end = there(0, joint) + missing[joint];
        c = k < kFlat && std::abs(c - end) < kRest ? end : std::clamp(c, lower, upper);
      }
      const double change = (spline.coefficient.col(joint) - before).cwiseAbs().maxCoeff();
      if (change > 2 * kRest || !inside()) spline.coefficient.col(joint) = before;
    }
  }
}

}  // namespace

PathFit fit_path(const RobotTable& robot, const std::vector<double>& clock,
                 const JointRows& samples, const std::vector<double>& allowance,
                 const FitTolerance& asked, double step_s) {
  FitTolerance tolerance = asked;
  if (asked.tip_m < kExact && asked.joint_rad < kExact) tolerance.duration_s = kExactDuration_s;
  tolerance.tip_m = std::max(asked.tip_m, kExact);
  tolerance.joint_rad = std::max(asked.joint_rad, kExact);
  const Leverage leverage = leverage_of(robot, samples);
  PathFit best;
  double least = std::numeric_limits<double>::infinity();
  for (int halving = 0; halving <= kHalvings && least > 1; ++halving, step_s *= 0.5) {
    PathFit out;
    out.spline.length = clock.back();
    out.spline.intervals = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(std::ceil(out.spline.length / step_s - 1e-9)));
    out.spline.coefficient.resize(out.spline.intervals + 5, samples.cols());
    const double excess = fit(robot, clock, samples, allowance, tolerance, leverage, out);
    if (excess >= least) break;
    least = excess;
    best = std::move(out);
  }
  meet_ends(robot, samples, best.spline);
  return best;
}

}  // namespace morphe::retime
