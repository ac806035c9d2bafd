#include "stages/retime/joint_spline.hpp"

#include <algorithm>
#include <cmath>

#include "stages/retime/banded.hpp"

namespace morphe {
namespace {

constexpr int kRounds = 30;
constexpr double kEndWeight = 1e5;    ///< the path's ends are kept
constexpr double kLimitWeight = 1e3;  ///< pulls a coefficient beyond a joint limit onto it
constexpr double kLeastRoughness = 1e-8;
constexpr double kLimitInset = 1e-7;  ///< [rad]: rounding must not leave the limits

struct Place {
  Eigen::Index interval = 0;
  double z = 0;
};

Place place_of(double u, double step, Eigen::Index intervals) {
  const double knots = std::clamp(u / step, 0.0, static_cast<double>(intervals));
  const auto interval = std::min(static_cast<Eigen::Index>(knots), intervals - 1);
  return {interval, knots - static_cast<double>(interval)};
}

/// Where the samples lie among the knots; the same for all joints.
struct Rows {
  std::vector<Eigen::Index> interval;
  std::vector<std::array<double, 6>> weights;
  std::vector<double> importance, tolerance;
  Eigen::VectorXd roughness;  ///< weight of each third difference
};

Rows rows_of(const std::vector<double>& clock, const std::vector<SmoothingAt>& smoothing,
             const JointSpline& spline) {
  Rows rows;
  rows.roughness = Eigen::VectorXd::Constant(spline.coefficient.rows() - 3, kLeastRoughness);
  for (std::size_t i = 0; i < clock.size(); ++i) {
    const Place at = place_of(clock[i], spline.step(), spline.intervals);
    rows.interval.push_back(at.interval);
    rows.weights.push_back(bspline_weights<5>(at.z));
    rows.tolerance.push_back(smoothing[i].tolerance);
    const double lambda = std::pow(smoothing[i].duration / spline.step(), 6);
    for (Eigen::Index k = 0; k < 3; ++k) {
      double& here = rows.roughness[at.interval + k];
      here = std::max(here, lambda);
    }
    const double before = i > 0 ? clock[i] - clock[i - 1] : 0;
    const double after = i + 1 < clock.size() ? clock[i + 1] - clock[i] : 0;
    rows.importance.push_back(std::max(0.02, 0.5 * (before + after) / spline.step()));
  }
  rows.importance.front() = rows.importance.back() = kEndWeight;
  return rows;
}

void add_roughness(BandedMatrix& normal, const Eigen::VectorXd& roughness) {
  constexpr std::array<double, 4> third{-1, 3, -3, 1};
  for (Eigen::Index i = 0; i < roughness.size(); ++i) {
    for (std::size_t a = 0; a < 4; ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        normal.entry(i + static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(a - b)) +=
            roughness[i] * third[a] * third[b];
      }
    }
  }
}

double value_of(const Eigen::VectorXd& c, const Rows& rows, std::size_t i) {
  double value = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    value += rows.weights[i][k] * c[rows.interval[i] + static_cast<Eigen::Index>(k)];
  }
  return value;
}

struct JointLimits {
  double lower = 0, upper = 0;
};

Eigen::VectorXd solve_joint(const Rows& rows, const Eigen::VectorXd& y,
                            const std::vector<double>& weight, const Eigen::VectorXd& pull,
                            const Eigen::VectorXd& pulled_to) {
  BandedMatrix normal(pull.size(), 5);
  Eigen::VectorXd right = pull.cwiseProduct(pulled_to);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    for (std::size_t a = 0; a < 6; ++a) {
      const Eigen::Index row = rows.interval[i] + static_cast<Eigen::Index>(a);
      const double weighted = weight[i] * rows.weights[i][a];
      right[row] += weighted * y[static_cast<Eigen::Index>(i)];
      for (std::size_t b = 0; b <= a; ++b) {
        normal.entry(row, static_cast<Eigen::Index>(a - b)) += weighted * rows.weights[i][b];
      }
    }
  }
  for (Eigen::Index i = 0; i < normal.size; ++i) normal.entry(i, 0) += pull[i];
  add_roughness(normal, rows.roughness);
  // A trace of damping settles what neither samples nor neighbours determine; more if rounding ate
  // it.
  for (double damping = 1e-10 * (1 + rows.roughness.minCoeff());; damping *= 1e3) {
    BandedMatrix damped = normal;
    for (Eigen::Index i = 0; i < damped.size; ++i) damped.entry(i, 0) += damping;
    if (!factor(damped)) continue;
    solve_factored(damped, right);
    return right;
  }
}

Eigen::VectorXd fit_joint(const Rows& rows, const Eigen::VectorXd& y, const JointLimits& limits) {
  std::vector<double> weight = rows.importance;
  const Eigen::Index coefficients = rows.roughness.size() + 3;
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(coefficients), pulled_to = pull, c;
  for (int round = 0; round < kRounds; ++round) {
    c = solve_joint(rows, y, weight, pull, pulled_to);
    bool settled = true;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      const double off = std::abs(value_of(c, rows, i) - y[static_cast<Eigen::Index>(i)]);
      const double tolerance = rows.tolerance[i];
      if (off <= tolerance || weight[i] > 1e8) continue;
      weight[i] *= std::clamp(off * off / (tolerance * tolerance), 2.0, 100.0);
      settled = false;
    }
    for (Eigen::Index k = 0; k < coefficients; ++k) {
      const double inside = std::clamp(c[k], limits.lower, limits.upper);
      if (inside == c[k]) continue;
      settled = settled && std::abs(inside - c[k]) < 1e-5;
      pulled_to[k] = inside;
      pull[k] = std::max(kLimitWeight, 3 * pull[k]);
    }
    if (settled) break;
  }
  return c.cwiseMax(limits.lower).cwiseMin(limits.upper);
}

}  // namespace

void evaluate(const JointSpline& spline, double u, JointRows& out) {
  const Place at = place_of(u, spline.step(), spline.intervals);
  out.setZero(4, spline.coefficient.cols());
  const auto value = bspline_weights<5>(at.z);
  const auto first = bspline_weights<4>(at.z);
  const auto second = bspline_weights<3>(at.z);
  const auto third = bspline_weights<2>(at.z);
  const double rate = 1 / spline.step();
  // Weights of the coefficients themselves: each derivative is a difference of the lower degree.
  std::array<std::array<double, 6>, 4> w{};
  for (std::size_t k = 0; k < 6; ++k) w[0][k] = value[k];
  const auto spread = [&](std::size_t order, const auto& weights, std::array<double, 4> binomial) {
    for (std::size_t k = 0; k < weights.size(); ++k) {
      for (std::size_t d = 0; d <= order; ++d) {
        w[order][k + d] += weights[k] * binomial[d] * std::pow(rate, static_cast<double>(order));
      }
    }
  };
  spread(1, first, {-1, 1, 0, 0});
  spread(2, second, {1, -2, 1, 0});
  spread(3, third, {-1, 3, -3, 1});
  for (std::size_t order = 0; order < 4; ++order) {
    for (std::size_t k = 0; k < 6; ++k) {
      out.row(static_cast<Eigen::Index>(order)) +=
          w[order][k] * spline.coefficient.row(at.interval + static_cast<Eigen::Index>(k));
    }
  }
}

JointSpline fit_spline(const std::vector<double>& clock, const JointRows& samples,
                       const std::vector<SmoothingAt>& smoothing, const JointVector& lower,
                       const JointVector& upper, double step_s) {
  JointSpline spline;
  spline.length = clock.back();
  spline.intervals = std::max<Eigen::Index>(
      1, static_cast<Eigen::Index>(std::ceil(spline.length / step_s - 1e-9)));
  spline.coefficient.resize(spline.intervals + 5, samples.cols());
  const Rows rows = rows_of(clock, smoothing, spline);
  for (Eigen::Index joint = 0; joint < samples.cols(); ++joint) {
    const double inset = std::min(kLimitInset, 0.25 * (upper[joint] - lower[joint]));
    // Fitting the offset from the first sample keeps the damping from moving a constant.
    const double origin = samples(0, joint);
    const Eigen::VectorXd c =
        fit_joint(rows, samples.col(joint).array() - origin,
                  {lower[joint] + inset - origin, upper[joint] - inset - origin});
    spline.coefficient.col(joint) = c.array() + origin;
  }
  return spline;
}

double deviation(const JointSpline& spline, const std::vector<double>& clock,
                 const JointRows& samples) {
  double worst = 0;
  JointRows at;
  for (std::size_t i = 0; i < clock.size(); ++i) {
    evaluate(spline, clock[i], at);
    const auto row = static_cast<Eigen::Index>(i);
    worst = std::max(worst, (at.row(0) - samples.row(row)).cwiseAbs().maxCoeff());
  }
  return worst;
}

}  // namespace morphe
