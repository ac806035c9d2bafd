#include "stages/retime/fit_path.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/banded.hpp"
#include "core/math/quintic.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "stages/retime/constants.hpp"
#include "stages/retime/limited_fit.hpp"

namespace morphe::retime {
namespace {

/// The Jacobians of the tips' positions at each sample, and the joints that move no tip.
struct TipJacobians {
  std::vector<Eigen::MatrixXd> jacobian;  ///< [W] of [3 m, n]
  Eigen::ArrayXd bare;                    ///< [n] 1 for a joint that moves no tip, otherwise 0
};

TipJacobians tip_jacobians_of(const RobotModel& robot, const JointRows& samples) {
  TipJacobians out;
  const Eigen::Index n = samples.cols(), tips = std::ssize(robot.tips);
  out.bare = Eigen::ArrayXd::Ones(n);
  if (tips == 0) return out;
  for (const RobotModel::Tip& tip : robot.tips) {
    for (const int frame : robot::ancestors(robot, tip.frame)) {
      const int joint = robot::joint_of(robot, frame);
      if (joint >= 0) out.bare[joint] = 0;
    }
  }
  std::vector<Pose> base_from_frame;
  Eigen::MatrixXd jacobians(6 * tips, n);
  for (Eigen::Index i = 0; i < samples.rows(); ++i) {
    const JointVector q = samples.row(i).transpose();
    robot::forward_kinematics(robot, q, base_from_frame);
    robot::tip_jacobians(robot, base_from_frame, jacobians);
    Eigen::MatrixXd& points = out.jacobian.emplace_back(3 * tips, n);
    for (int t = 0; t < tips; ++t) points.middleRows<3>(3 * t) = jacobians.middleRows<3>(6 * t);
  }
  return out;
}

struct Deviation {
  double tip = 0, bare = 0, any = 0;
};
Deviation deviation_at(const TipJacobians& tips, int i, const JointVector& offset) {
  Deviation out;
  out.any = offset.cwiseAbs().maxCoeff();
  out.bare = (offset.array().abs() * tips.bare).maxCoeff();
  if (tips.jacobian.empty()) return out;
  const Eigen::VectorXd moved = tips.jacobian[i] * offset;
  for (int t = 0; t < moved.size(); t += 3) out.tip = std::max(out.tip, moved.segment<3>(t).norm());
  return out;
}

/// The positions of the samples among the knots and their weights, the same for all joints.
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
  for (int i = 0; i < std::ssize(clock); ++i) {
    const math::KnotPosition place = math::knot_position(spline, clock[i]);
    rows.place.push_back(place);
    const auto basis = math::bspline_weights<5>(place.z);
    rows.basis.emplace_back(basis.data());
    const double roughness = std::min(
        kMaxRoughnessWeight, std::pow(allowance[i] * duration_s / spline.knot_spacing(), 6));
    for (int k = 0; k < 3; ++k) {
      double& weight = rows.roughness[place.interval + k];
      weight = std::max(weight, roughness);
    }
    const double before = i > 0 ? clock[i] - clock[i - 1] : 0;
    const double after = i + 1 < std::ssize(clock) ? clock[i + 1] - clock[i] : 0;
    rows.weight.push_back(
        std::max(kMinSampleWeight, 0.5 * (before + after) / spline.knot_spacing()));
  }
  rows.weight.front() = rows.weight.back() = kEndWeight;
  return rows;
}

/// Raises each weight to at least kMinNeighbourWeightRatio of its neighbours', except at the ends.
void smooth_weights(std::vector<double>& weight) {
  for (int i = 2; i + 1 < std::ssize(weight); ++i)
    weight[i] = std::max(weight[i], kMinNeighbourWeightRatio * weight[i - 1]);
  for (std::ptrdiff_t i = std::ssize(weight) - 3; i > 0; --i)
    weight[i] = std::max(weight[i], kMinNeighbourWeightRatio * weight[i + 1]);
}

/// Sets the limit weight of each interval above the weights of the samples that share coefficients
/// with it.
void weigh_limits(Rows& rows) {
  const Eigen::Index intervals = rows.roughness.size() - 2;
  rows.limit_weight = Eigen::VectorXd::Constant(intervals, kMinLimitSampleWeight);
  for (int i = 0; i < std::ssize(rows.weight); ++i) {
    const Eigen::Index first = std::max<Eigen::Index>(0, rows.place[i].interval - 5);
    const Eigen::Index last = std::min(intervals - 1, rows.place[i].interval + 5);
    for (Eigen::Index k = first; k <= last; ++k)
      rows.limit_weight[k] = std::max(rows.limit_weight[k], rows.weight[i]);
  }
  rows.limit_weight = (kLimitWeight * rows.limit_weight).cwiseMin(kMaxLimitWeight);
}
math::BandedMatrix normal_of(const Rows& rows) {
  math::BandedMatrix normal(rows.roughness.size() + 3, 5);
  for (int i = 0; i < std::ssize(rows.weight); ++i)
    add_form(normal, rows.place[i].interval, rows.weight[i], rows.basis[i].data());
  constexpr std::array<double, 4> third{-1, 3, -3, 1};
  for (int i = 0; i < rows.roughness.size(); ++i) {
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b <= a; ++b)
        normal.entry(i + a, a - b) += rows.roughness[i] * third[a] * third[b];
  }
  return normal;
}

void solve(Rows& rows, const JointRows& offset, const JointVector& lower, const JointVector& upper,
           std::vector<LimitMultipliers>& pulls, JointRows& coefficient) {
  coefficient.setZero();
  for (int i = 0; i < std::ssize(rows.weight); ++i) {
    for (int a = 0; a < 6; ++a) {
      coefficient.row(rows.place[i].interval + a) +=
          (rows.weight[i] * rows.basis[i][a]) * offset.row(i);
    }
  }
  const JointRows rhs = coefficient;
  const math::BandedMatrix free = normal_of(rows);
  math::solve_factored(factor_damped(free), coefficient);
  for (int joint = 0; joint < std::ssize(pulls); ++joint) {
    Eigen::VectorXd c = coefficient.col(joint);
    // The curve is also inside the convex hull of its coefficients.
    const bool inside = c.minCoeff() >= lower[joint] && c.maxCoeff() <= upper[joint];
    if (inside && pulls[joint].side.size() == 0) continue;
    if (rows.limit_weight.size() == 0) weigh_limits(rows);
    solve_within_limits({free, rhs.col(joint), rows.limit_weight, lower[joint], upper[joint]},
                        pulls[joint], c);
    coefficient.col(joint) = c;
  }
}

/// Fits once on given knots and returns the largest ratio of a deviation to its tolerance.
double fit(const RobotModel& robot, const std::vector<double>& clock, const JointRows& samples,
           const std::vector<double>& allowance, const FitTolerance& tolerance,
           const TipJacobians& tips, PathFit& out) {
  Rows rows = rows_of(clock, allowance, tolerance.duration_s, out.spline);
  // Fits offsets from the first sample, because damping must not move a constant.
  const Eigen::RowVectorXd origin =
      samples.row(0).cwiseMax(robot.lower.transpose()).cwiseMin(robot.upper.transpose());
  const JointRows offset = samples.rowwise() - origin;
  const JointVector inset = (0.25 * (robot.upper - robot.lower)).cwiseMin(kLimitInset_rad);
  const JointVector lower = robot.lower + inset - origin.transpose();
  const JointVector upper = robot.upper - inset - origin.transpose();
  std::vector<LimitMultipliers> pulls(samples.cols());
  JointRows& coefficient = out.spline.coefficient;
  double excess = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    rows.limit_weight.resize(0);
    solve(rows, offset, lower, upper, pulls, coefficient);
    bool settled = true;
    excess = out.tip_deviation = out.joint_deviation = 0;
    for (int i = 0; i < std::ssize(clock); ++i) {
      const JointVector residual =
          coefficient.middleRows<6>(rows.place[i].interval).transpose() * rows.basis[i] -
          offset.row(i).transpose();
      const Deviation deviation = deviation_at(tips, i, residual);
      out.tip_deviation = std::max(out.tip_deviation, deviation.tip);
      out.joint_deviation = std::max(out.joint_deviation, deviation.any);
      const double ratio = std::max(deviation.tip / (kLinearizationShare * tolerance.tip_m),
                                    deviation.bare / tolerance.joint_rad) /
                           allowance[i];
      excess = std::max(excess, ratio);
      if (ratio <= 1 || rows.weight[i] > kMaxSampleWeight) continue;
      rows.weight[i] *= std::clamp(ratio * ratio, kMinWeightGrowth, kMaxWeightGrowth);
      if (round >= kRoundsBeforeRelaxing)
        rows.roughness.segment<3>(rows.place[i].interval) *= kRoughnessReductionRatio;
      settled = false;
    }
    if (settled) break;
    smooth_weights(rows.weight);
  }
  out.spline.origin = origin;
  return excess;
}

/// Returns true if a joint's curve, quintics between knots, is inside its limits from knot `from`
/// to knot `to`.
bool stays_inside(const math::JointSpline& spline, Eigen::Index joint, Eigen::Index from,
                  Eigen::Index to, double lower, double upper) {
  const double spacing = spline.knot_spacing();
  JointRows q;
  const auto state_at = [&](Eigen::Index knot) {
    math::evaluate(spline, spacing * static_cast<double>(knot), q);
    return math::JointState{q(0, joint), q(1, joint), q(2, joint)};
  };
  math::JointState begin = state_at(from);
  for (Eigen::Index knot = from + 1; knot <= to; ++knot) {
    const math::JointState end = state_at(knot);
    if (math::limit_excess(math::quintic_piece(begin, end, spacing), lower, upper) > 0)
      return false;
    begin = end;
  }
  return true;
}

/// Returns the coefficients with `missing` added at an end and fading out over `fade` knots.
Eigen::VectorXd with_end(Eigen::VectorXd curve, double missing, bool first, Eigen::Index fade) {
  for (Eigen::Index k = 0; k < kFlatKnots + fade; ++k) {
    const double z = static_cast<double>(std::max<Eigen::Index>(0, k - kFlatKnots + 1)) /
                     static_cast<double>(fade + 1);
    const double share = 1 - z * z * z * (10 + z * (6 * z - 15));
    curve[first ? k : curve.size() - 1 - k] += share * missing;
  }
  return curve;
}

/// Moves the curve onto an end that it misses in spite of the end's weight. The correction fades
/// out over kFadeKnots, over fewer if the curve would otherwise leave a joint's limits. If it
/// leaves them even then, coefficients at rest at the end are set to it and the others are clamped
/// to the limits. The end stays missed if that changes a coefficient much or does not help.
void meet_ends(const RobotModel& robot, const JointRows& samples, math::JointSpline& spline) {
  const Eigen::Index count = spline.coefficient.rows();
  const Eigen::Index max_fade = std::min<Eigen::Index>(kFadeKnots, count / 2 - kFlatKnots);
  if (max_fade < 1) return;
  JointRows q;
  for (const bool first : {true, false}) {
    math::evaluate(spline, first ? 0 : spline.duration_s, q);
    const Eigen::RowVectorXd missing = samples.row(first ? 0 : samples.rows() - 1) - q.row(0);
    const Eigen::Index affected = std::min(spline.intervals, kFlatKnots + max_fade);
    const Eigen::Index from = first ? 0 : spline.intervals - affected;
    for (int joint = 0; joint < missing.size(); ++joint) {
      if (std::abs(missing[joint]) <= 2 * kLimitInset_rad) continue;
      const double lower = robot.lower[joint] + 0.5 * kLimitInset_rad,
                   upper = robot.upper[joint] - 0.5 * kLimitInset_rad;
      const auto inside = [&] {
        return stays_inside(spline, joint, from, from + affected, lower, upper);
      };
      const Eigen::VectorXd before = spline.coefficient.col(joint);
      const auto fading = [&](Eigen::Index fade) {
        spline.coefficient.col(joint) = with_end(before, missing[joint], first, fade);
      };
      Eigen::Index fade = max_fade;
      fading(fade);
      while (!inside() && fade / 2 >= kMinFadeKnots) fading(fade /= 2);
      if (inside()) continue;
      fading(max_fade);
      for (Eigen::Index k = 0; k < kFlatKnots + max_fade; ++k) {
        double& c = spline.coefficient(first ? k : count - 1 - k, joint);
        const double end = q(0, joint) + missing[joint];
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
                 const FitTolerance& requested, double step_s) {
  FitTolerance tolerance = requested;
  if (requested.tip_m < kMinTolerance && requested.joint_rad < kMinTolerance)
    tolerance.duration_s = kMinSmoothing_s;
  tolerance.tip_m = std::max(requested.tip_m, kMinTolerance);
  tolerance.joint_rad = std::max(requested.joint_rad, kMinTolerance);
  const TipJacobians tips = tip_jacobians_of(robot, samples);
  PathFit best;
  double best_excess = kInfinity;
  for (int halving = 0; halving <= kMaxStepHalvings && best_excess > 1; ++halving, step_s *= 0.5) {
    PathFit out;
    out.spline.duration_s = clock.back();
    out.spline.intervals = std::max<Eigen::Index>(
        1, static_cast<Eigen::Index>(std::ceil(out.spline.duration_s / step_s - 1e-9)));
    out.spline.coefficient.resize(out.spline.intervals + 5, samples.cols());
    const double excess = fit(robot, clock, samples, allowance, tolerance, tips, out);
    if (excess >= best_excess) break;
    best_excess = excess;
    best = std::move(out);
  }
  meet_ends(robot, samples, best.spline);
  return best;
}

}  // namespace morphe::retime
