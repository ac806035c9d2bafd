#include "stages/retime/fit_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/banded.hpp"
#include "core/math/quintic.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/retime/limited_fit.hpp"

namespace morphe::retime {
namespace {

/// after kRoundsBeforeRelaxing the roughness weight is reduced around samples out of tolerance
constexpr int kMaxRounds = 30, kRoundsBeforeRelaxing = 6;
constexpr int kMaxStepHalvings = 2;
constexpr double kRoughnessReductionRatio = 0.5;
constexpr double kEndWeight = 1e5;        ///< keeps the path's ends
constexpr double kMaxSampleWeight = 1e8;  ///< beyond it rounding errors dominate
constexpr double kLimitWeight = 100;  ///< weight of a point pulled onto a joint limit, relative …
constexpr double kMaxLimitWeight = 1e10;  ///< … to the weights of the samples around it
/// limits of double precision
constexpr double kMinRoughnessWeight = 1e-8, kMaxRoughnessWeight = 1e6;
/// share of the tip tolerance that is used, because the Jacobian is a linearisation
constexpr double kLinearizationShare = 0.98;
constexpr double kMinSmoothingDuration_s = 0.003, kMinTolerance = 1e-5;

/// The Jacobians of the tips' positions at each sample, and the joints on which no tip depends.
struct TipJacobians {
  std::vector<Eigen::MatrixXd> jacobian;  ///< [W] of [3 m, n]
  Eigen::ArrayXd bare;                    ///< [n] 1 for a joint that moves no tip, otherwise 0
};

TipJacobians tip_jacobians_of(const RobotModel& robot, const JointRows& samples) {
  TipJacobians out;
  const Eigen::Index n = samples.cols();
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  out.bare = Eigen::ArrayXd::Ones(n);
  if (tips == 0) return out;
  for (const RobotModel::Tip& tip : robot.tips) {
    for (const int frame : robot::ancestors(robot, tip.frame)) {
      const int joint = robot::joint_of(robot, frame);
      if (joint >= 0) out.bare[joint] = 0;
    }
  }
  std::vector<Pose> base_from_frame;
  Eigen::MatrixXd both(6 * tips, n);
  for (Eigen::Index i = 0; i < samples.rows(); ++i) {
    const JointVector q = samples.row(i).transpose();
    robot::forward_kinematics(robot, q, base_from_frame);
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
Deviation deviation_at(const TipJacobians& leverage, std::size_t i, const JointVector& off) {
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

/// The positions of the samples among the knots and their weights, which are the same for all
/// joints.
struct Rows {
  std::vector<math::KnotPosition> place;
  std::vector<Eigen::Matrix<double, 6, 1>> basis;
  std::vector<double> weight;
  Eigen::VectorXd roughness;     ///< weight of each third difference
  Eigen::VectorXd limit_weight;  ///< weight of points pulled onto a limit, for each interval
};

Rows rows_of(const std::vector<double>& clock, const std::vector<double>& allowance,
             double duration_s, const math::JointSpline& spline) {
  Rows rows;
  rows.roughness = Eigen::VectorXd::Constant(spline.coefficient.rows() - 3, kMinRoughnessWeight);
  for (std::size_t i = 0; i < clock.size(); ++i) {
    const math::KnotPosition at = math::knot_position(spline, clock[i]);
    rows.place.push_back(at);
    const auto basis = math::bspline_weights<5>(at.z);
    rows.basis.emplace_back(basis.data());
    const double roughness = std::min(
        kMaxRoughnessWeight, std::pow(allowance[i] * duration_s / spline.knot_spacing(), 6));
    for (Eigen::Index k = 0; k < 3; ++k) {
      double& here = rows.roughness[at.interval + k];
      here = std::max(here, roughness);
    }
    const double before = i > 0 ? clock[i] - clock[i - 1] : 0;
    const double after = i + 1 < clock.size() ? clock[i + 1] - clock[i] : 0;
    rows.weight.push_back(std::max(0.02, 0.5 * (before + after) / spline.knot_spacing()));
  }
  rows.weight.front() = rows.weight.back() = kEndWeight;
  return rows;
}

/// Raises each sample's weight to at least a tenth of its neighbours', because a single large
/// weight would only make the curve oscillate around its sample. The ends keep their weights.
void smooth_weights(std::vector<double>& weight) {
  constexpr double kMinNeighbourShare = 0.1;
  for (std::size_t i = 2; i + 1 < weight.size(); ++i) {
    weight[i] = std::max(weight[i], kMinNeighbourShare * weight[i - 1]);
  }
  for (std::size_t i = weight.size() - 2; i-- > 1;) {
    weight[i] = std::max(weight[i], kMinNeighbourShare * weight[i + 1]);
  }
}

/// Weighs the limits more than the samples that share coefficients with an interval.
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
  rows.limit_weight = (kLimitWeight * rows.limit_weight).cwiseMin(kMaxLimitWeight);
}

/// Returns the matrix of the normal equations without pulled points.
math::BandedMatrix normal_of(const Rows& rows) {
  math::BandedMatrix normal(rows.roughness.size() + 3, 5);
  for (std::size_t i = 0; i < rows.weight.size(); ++i) {
    add_form(normal, rows.place[i].interval, rows.weight[i], rows.basis[i].data());
  }
  constexpr std::array<double, 4> third{-1, 3, -3, 1};
  for (Eigen::Index i = 0; i < rows.roughness.size(); ++i) {
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        normal.entry(i + a, a - b) += rows.roughness[i] * third[a] * third[b];
      }
    }
  }
  return normal;
}

void solve(Rows& rows, const JointRows& offset, const JointVector& lower, const JointVector& upper,
           std::vector<LimitMultipliers>& pulls, JointRows& coefficient) {
  coefficient.setZero();
  for (std::size_t i = 0; i < rows.weight.size(); ++i) {
    for (Eigen::Index a = 0; a < 6; ++a) {
      coefficient.row(rows.place[i].interval + a) +=
          (rows.weight[i] * rows.basis[i][a]) * offset.row(i);
    }
  }
  const JointRows right = coefficient;
  const math::BandedMatrix free = normal_of(rows);
  math::solve_factored(factor_damped(free), coefficient);
  for (std::size_t joint = 0; joint < pulls.size(); ++joint) {
    const auto column = static_cast<Eigen::Index>(joint);
    Eigen::VectorXd c = coefficient.col(column);
    // The curve is also inside the convex hull of its coefficients.
    const bool inside = c.minCoeff() >= lower[column] && c.maxCoeff() <= upper[column];
    if (inside && pulls[joint].side.size() == 0) continue;
    if (rows.limit_weight.size() == 0) weigh_limits(rows);
    solve_within_limits({free, right.col(column), rows.limit_weight, lower[column], upper[column]},
                        pulls[joint], c);
    coefficient.col(column) = c;
  }
}

/// Fits once on given knots and returns the largest ratio of a deviation to its tolerance; the fit
/// is within the tolerances if it is <= 1.
double fit(const RobotModel& robot, const std::vector<double>& clock, const JointRows& samples,
           const std::vector<double>& allowance, const FitTolerance& tolerance,
           const TipJacobians& leverage, PathFit& out) {
  Rows rows = rows_of(clock, allowance, tolerance.duration_s, out.spline);
  // Fits offsets from the first sample, because damping must not move a constant.
  const Eigen::RowVectorXd origin =
      samples.row(0).cwiseMax(robot.lower.transpose()).cwiseMin(robot.upper.transpose());
  const JointRows offset = samples.rowwise() - origin;
  const Eigen::Index n = samples.cols();
  const JointVector inset = (0.25 * (robot.upper - robot.lower)).cwiseMin(kLimitInset_rad);
  const JointVector lower = robot.lower + inset - origin.transpose();
  const JointVector upper = robot.upper - inset - origin.transpose();
  std::vector<LimitMultipliers> pulls(n);
  JointRows& coefficient = out.spline.coefficient;
  double excess = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    rows.limit_weight.resize(0);
    solve(rows, offset, lower, upper, pulls, coefficient);
    bool settled = true;
    excess = out.tip_deviation = out.joint_deviation = 0;
    for (std::size_t i = 0; i < clock.size(); ++i) {
      const JointVector off =
          coefficient.middleRows<6>(rows.place[i].interval).transpose() * rows.basis[i] -
          offset.row(i).transpose();
      const Deviation here = deviation_at(leverage, i, off);
      out.tip_deviation = std::max(out.tip_deviation, here.tip);
      out.joint_deviation = std::max(out.joint_deviation, here.any);
      const double share = std::max(here.tip / (kLinearizationShare * tolerance.tip_m),
                                    here.bare / tolerance.joint_rad) /
                           allowance[i];
      excess = std::max(excess, share);
      if (share <= 1 || rows.weight[i] > kMaxSampleWeight) continue;
      rows.weight[i] *= std::clamp(share * share, 2.0, 100.0);
      if (round >= kRoundsBeforeRelaxing) {
        rows.roughness.segment<3>(rows.place[i].interval) *= kRoughnessReductionRatio;
      }
      settled = false;
    }
    if (settled) break;
    smooth_weights(rows.weight);
  }
  out.spline.origin = origin;
  return excess;
}

/// Returns true if a joint's curve is inside its limits between the knots `from` and `to`, where
/// each interval is the quintic that interpolates its two ends.
bool stays_inside(const math::JointSpline& spline, Eigen::Index joint, Eigen::Index from,
                  Eigen::Index to, double lower, double upper) {
  JointRows at;
  const auto state_at = [&](Eigen::Index knot) {
    math::evaluate(spline, spline.knot_spacing() * static_cast<double>(knot), at);
    return math::JointState{at(0, joint), at(1, joint), at(2, joint)};
  };
  math::JointState begin = state_at(from);
  for (Eigen::Index knot = from + 1; knot <= to; ++knot) {
    const math::JointState end = state_at(knot);
    if (math::limit_excess(math::quintic_piece(begin, end, spline.knot_spacing()), lower, upper) >
        0)
      return false;
    begin = end;
  }
  return true;
}

/// Returns the coefficients with the deviation at a missed end added there, fading out over `fade`
/// knots.
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

/// If an end was missed in spite of its weight, adds the deviation to the coefficients there and
/// fades it out over some knots, over fewer if the curve would leave a joint's limits. If it leaves
/// them even then, coefficients that are at rest at the end are held there and all are clamped to
/// the limits, unless that would change the curve by much.
void meet_ends(const RobotModel& robot, const JointRows& samples, math::JointSpline& spline) {
  // a knot's value is the mean of five coefficients
  constexpr Eigen::Index kFlatKnots = 5, kFadeKnots = 25;
  constexpr Eigen::Index kMinFadeKnotCount = 5;
  // coefficients closer to the end count as at rest [rad]
  constexpr double kRestTolerance_rad = 1e-4;
  const Eigen::Index count = spline.coefficient.rows();
  const Eigen::Index longest = std::min(kFadeKnots, count / 2 - kFlatKnots);
  if (longest < 1) return;
  JointRows there;
  for (const bool first : {true, false}) {
    math::evaluate(spline, first ? 0 : spline.duration_s, there);
    const Eigen::RowVectorXd missing = samples.row(first ? 0 : samples.rows() - 1) - there.row(0);
    const Eigen::Index reach = std::min(spline.intervals, kFlatKnots + longest);
    const Eigen::Index from = first ? 0 : spline.intervals - reach;
    for (Eigen::Index joint = 0; joint < missing.size(); ++joint) {
      if (std::abs(missing[joint]) <= 2 * kLimitInset_rad) continue;
      const double lower = robot.lower[joint] + 0.5 * kLimitInset_rad,
                   upper = robot.upper[joint] - 0.5 * kLimitInset_rad;
      const auto inside = [&] {
        return stays_inside(spline, joint, from, from + reach, lower, upper);
      };
      const Eigen::VectorXd before = spline.coefficient.col(joint);
      const auto fading = [&](Eigen::Index fade) {
        spline.coefficient.col(joint) = with_end(before, missing[joint], first, kFlatKnots, fade);
      };
      Eigen::Index fade = longest;
      fading(fade);
      while (!inside() && fade / 2 >= kMinFadeKnotCount) fading(fade /= 2);
      if (inside()) continue;
      fading(longest);
      for (Eigen::Index k = 0; k < kFlatKnots + longest; ++k) {
        double& c = spline.coefficient(first ? k : count - 1 - k, joint);
        const double end = there(0, joint) + missing[joint];
        c = k < kFlatKnots && std::abs(c - end) < kRestTolerance_rad ? end
                                                                     : std::clamp(c, lower, upper);
      }
      const double change = (spline.coefficient.col(joint) - before).cwiseAbs().maxCoeff();
      if (change > 2 * kRestTolerance_rad || !inside()) spline.coefficient.col(joint) = before;
    }
  }
}

}  // namespace

PathFit fit_path(const RobotModel& robot, const std::vector<double>& clock,
                 const JointRows& samples, const std::vector<double>& allowance,
                 const FitTolerance& asked, double step_s) {
  FitTolerance tolerance = asked;
  if (asked.tip_m < kMinTolerance && asked.joint_rad < kMinTolerance)
    tolerance.duration_s = kMinSmoothingDuration_s;
  tolerance.tip_m = std::max(asked.tip_m, kMinTolerance);
  tolerance.joint_rad = std::max(asked.joint_rad, kMinTolerance);
  const TipJacobians leverage = tip_jacobians_of(robot, samples);
  PathFit best;
  double least = std::numeric_limits<double>::infinity();
  for (int halving = 0; halving <= kMaxStepHalvings && least > 1; ++halving, step_s *= 0.5) {
    PathFit out;
    out.spline.duration_s = clock.back();
    out.spline.intervals = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(std::ceil(out.spline.duration_s / step_s - 1e-9)));
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
