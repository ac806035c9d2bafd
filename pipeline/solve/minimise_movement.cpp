#include "pipeline/solve/minimise_movement.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <vector>

#include "pipeline/solve/band_cholesky.hpp"

namespace morphe {
namespace {

using Eigen::Index;
/// Coefficients of the forward differences of order 1, 2 and 3.
const std::array<std::vector<double>, 3> kDifferences{{{-1, 1}, {1, -2, 1}, {-1, 3, -3, 1}}};

using Held = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Everything at one point of the search.
struct Point {
  JointRows q;
  std::vector<Quadratic> models;
  double frame_value = 0, value = 0;
};

JointVector difference(const JointRows& q, Index f, const std::vector<double>& coefficients) {
  JointVector sum = JointVector::Zero(q.cols());
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    sum += coefficients[k] * q.row(f + static_cast<Index>(k)).transpose();
  }
  return sum;
}

/// Calls visit(first frame, coefficients, weight) for every difference of the movement.
template <class Visit>
void each_difference(const MovementProblem& problem, const Visit& visit) {
  for (std::size_t order = 0; order < kDifferences.size(); ++order) {
    const auto span = static_cast<Index>(kDifferences[order].size());
    for (Index f = 0; f + span <= static_cast<Index>(problem.frames); ++f) {
      visit(f, kDifferences[order], problem.difference_weight[order]);
    }
  }
}

void evaluate(const MovementProblem& problem, Point& point) {
  const Index n = point.q.cols();
  point.models.resize(problem.frames);
  point.frame_value = 0;
  JointVector q(n);
  for (std::size_t f = 0; f < problem.frames; ++f) {
    point.models[f].reset(n);
    q = point.q.row(static_cast<Index>(f));
    problem.frame_model(f, q, point.models[f]);
    point.frame_value += point.models[f].value;
  }
  point.value = point.frame_value;
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    point.value += difference(point.q, f, coefficients).cwiseAbs2().dot(weight);
  });
}

JointRows gradient(const MovementProblem& problem, const Point& point) {
  JointRows g(point.q.rows(), point.q.cols());
  for (Index f = 0; f < g.rows(); ++f) {
    g.row(f) = point.models[static_cast<std::size_t>(f)].gradient.transpose();
  }
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    const JointVector weighted = 2 * difference(point.q, f, coefficients).cwiseProduct(weight);
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      g.row(f + static_cast<Index>(k)) += coefficients[k] * weighted.transpose();
    }
  });
  return g;
}

/// What the differences add to the Hessian: for each frame the diagonals of its blocks with itself
/// and the three frames before, [n, 4].
std::vector<Eigen::MatrixXd> difference_curvature(const MovementProblem& problem) {
  std::vector<Eigen::MatrixXd> curvature(
      problem.frames, Eigen::MatrixXd::Zero(problem.lower.size(), BandCholesky::kBandBlocks + 1));
  each_difference(problem, [&](Index f, const auto& coefficients, const JointVector& weight) {
    for (std::size_t a = 0; a < coefficients.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        curvature[static_cast<std::size_t>(f) + a].col(static_cast<Index>(a - b)) +=
            2 * coefficients[a] * coefficients[b] * weight;
      }
    }
  });
  return curvature;
}

/// (H + D) v, D = damping[f] on the diagonal of frame f; `between` from difference_curvature().
JointRows multiply(const std::vector<Eigen::MatrixXd>& between, const Point& point,
                   const JointVector& damping, const JointRows& v) {
  JointRows product = damping.asDiagonal() * v;
  for (Index f = 0; f < v.rows(); ++f) {
    const auto frame = static_cast<std::size_t>(f);
    product.row(f).noalias() += v.row(f) * point.models[frame].hessian;
    product.row(f) += v.row(f).cwiseProduct(between[frame].col(0).transpose());
    for (Index before = 1; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      const auto weight = between[frame].col(before).transpose();
      product.row(f) += v.row(f - before).cwiseProduct(weight);
      product.row(f - before) += v.row(f).cwiseProduct(weight);
    }
  }
  return product;
}

/// H + D with held variables cut out.
void damped_hessian(const std::vector<Eigen::MatrixXd>& between, const Point& point,
                    const Held& held, const JointVector& damping, BandCholesky& hessian) {
  const Index frames = point.q.rows(), n = point.q.cols();
  for (Index f = 0; f < frames; ++f) {
    const auto frame = static_cast<std::size_t>(f);
    hessian.clear(frame);
    auto own = hessian.block(frame, 0);
    own = point.models[frame].hessian;
    own.diagonal().array() += damping[f];
    own.diagonal() += between[frame].col(0);
    for (Index j = 0; j < n; ++j) {
      if (!held(f, j)) continue;
      own.row(j).setZero();
      own.col(j).setZero();
      own(j, j) = 1;
    }
    for (Index before = 1; before <= std::min(f, BandCholesky::kBandBlocks); ++before) {
      auto block = hessian.block(frame, before);
      for (Index j = 0; j < n; ++j) {
        if (!held(f, j) && !held(f - before, j)) block(j, j) = between[frame](j, before);
      }
    }
  }
}

/// Holds free variables that the step takes out of the bounds, on them, and frees held ones that
/// the slope of the model draws back inside; by how much the bounds were left.
double change_held(const MovementProblem& problem, const JointRows& q, const JointRows& slope,
                   JointRows& step, Held& held) {
  double outside = 0;
  for (Index f = 0; f < q.rows(); ++f) {
    for (Index j = 0; j < q.cols(); ++j) {
      const double to = q(f, j) + step(f, j), lower = problem.lower[j], upper = problem.upper[j];
      if (held(f, j)) {
        const double inwards = to > 0.5 * (lower + upper) ? slope(f, j) : -slope(f, j);
        if (inwards <= 0) continue;
        held(f, j) = false;
      } else {
        if (to >= lower && to <= upper) continue;
        step(f, j) = (to < lower ? lower : upper) - q(f, j);
        held(f, j) = true;
        outside = std::max(outside, std::max(lower - to, to - upper));
      }
    }
  }
  return outside;
}

/// Takes the negative curvature out of every frame's own model, where free variables see it and the
/// damping does not outweigh it.
void make_convex(Point& point, const Held& held, const JointVector& damping) {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own;
  Eigen::LLT<Eigen::MatrixXd> factor;
  Eigen::MatrixXd free;
  for (Index f = 0; f < point.q.rows(); ++f) {
    Eigen::MatrixXd& hessian = point.models[static_cast<std::size_t>(f)].hessian;
    free = hessian;
    for (Index j = 0; j < held.cols(); ++j) {
      if (!held(f, j)) continue;
      free.row(j).setZero();
      free.col(j).setZero();
      free(j, j) = 1;
    }
    free.diagonal().array() += damping[f];
    factor.compute(free);
    if (factor.info() == Eigen::Success) continue;
    free.diagonal().array() -= damping[f];
    own.compute(free);
    const Eigen::MatrixXd& axes = own.eigenvectors();
    hessian += axes * (-own.eigenvalues()).cwiseMax(0).asDiagonal() * axes.transpose();
  }
}

/// The step that minimises the damped model within the bounds, as nearly as a few changes of the
/// held variables find it. A model without a minimum is made convex, for good. False if the damping
/// does not suffice for that either.
bool bounded_step(const MovementProblem& problem, const std::vector<Eigen::MatrixXd>& between,
                  Point& now, const JointRows& g, const JointVector& damping, BandCholesky& hessian,
                  JointRows& step) {
  constexpr int kChanges = 2;
  constexpr double kOutside = 1e-4;  // clamping may cut off
  const Index frames = now.q.rows(), n = now.q.cols();
  Held held(frames, n);
  for (Index f = 0; f < frames; ++f) {
    for (Index j = 0; j < n; ++j) {
      held(f, j) = (now.q(f, j) <= problem.lower[j] && g(f, j) > 0) ||
                   (now.q(f, j) >= problem.upper[j] && g(f, j) < 0);
    }
  }
  step.setZero(frames, n);
  for (int change = 0; change < kChanges; ++change) {
    damped_hessian(between, now, held, damping, hessian);
    if (!hessian.factorise()) {
      make_convex(now, held, damping);
      damped_hessian(between, now, held, damping, hessian);
      if (!hessian.factorise()) return false;
    }
    JointRows right = held.select(0, -g);
    if (change > 0) {
      const JointRows held_step = held.select(step, 0);
      right = held.select(held_step, right - multiply(between, now, damping, held_step));
    }
    JointVector solved = Eigen::Map<const JointVector>(right.data(), right.size());
    hessian.solve(solved);
    step = Eigen::Map<const JointRows>(solved.data(), frames, n);
    const JointRows slope = g + multiply(between, now, damping, step);
    if (change_held(problem, now.q, slope, step, held) <= kOutside) break;
  }
  return true;
}

/// Damps frames whose steps are longer than models hold; false if there is none.
bool damp_long(const JointRows& g, const JointRows& step, JointVector& damping) {
  constexpr double kLongest = 0.5;  // of any variable
  bool any = false;
  for (Index f = 0; f < step.rows(); ++f) {
    const double ratio = step.row(f).cwiseAbs().maxCoeff() / kLongest;
    if (ratio <= 1.5) continue;
    // As if the step were all along one curvature.
    const double curvature = std::abs(g.row(f).dot(step.row(f))) / step.row(f).squaredNorm();
    damping[f] += std::max(damping[f], (ratio - 1) * curvature);
    any = true;
  }
  return any;
}

/// bounded_step() with the damping that keeps it short. False if the damping does not suffice.
bool short_step(const MovementProblem& problem, const std::vector<Eigen::MatrixXd>& between,
                Point& now, JointVector& damping, BandCholesky& hessian, JointRows& step) {
  constexpr int kAttempts = 5;
  const JointRows g = gradient(problem, now);
  bool solved = bounded_step(problem, between, now, g, damping, hessian, step);
  for (int k = 0; k < kAttempts && solved && damp_long(g, step, damping); ++k) {
    solved = bounded_step(problem, between, now, g, damping, hessian, step);
  }
  return solved;
}

/// Half of D's share at a step bounds what a frame's own model may be wrong by. Where it did not,
/// the damping that would have been enough; where it was far too much, less.
void adapt(const Point& from, const Point& to, bool taken, JointVector& damping) {
  constexpr double kLeast = 1e-6, kFall = 5, kRise = 1000, kRiseIfTaken = 2;
  JointVector step, bent;
  for (Index f = 0; f < from.q.rows(); ++f) {
    const Quadratic& model = from.models[static_cast<std::size_t>(f)];
    step = (to.q.row(f) - from.q.row(f)).transpose();
    const double squared = step.squaredNorm();
    if (squared == 0) continue;
    bent.noalias() = model.hessian * step;
    const double wrong = to.models[static_cast<std::size_t>(f)].value - model.value -
                         step.dot(model.gradient + 0.5 * bent);
    const double enough = 2 * wrong / squared;
    if (enough > damping[f]) {
      damping[f] = taken ? std::min(enough, kRiseIfTaken * damping[f])
                         : std::clamp(enough, 2 * damping[f], kRise * damping[f]);
    } else if (taken && enough < damping[f] / 4) {
      damping[f] = std::max(damping[f] / kFall, kLeast);
    }
  }
}

void clamp(const MovementProblem& problem, JointRows& q) {
  for (Index f = 0; f < q.rows(); ++f) {
    q.row(f) = q.row(f).cwiseMax(problem.lower.transpose()).cwiseMin(problem.upper.transpose());
  }
}

}  // namespace

MovementMinimum minimise_movement(const MovementProblem& problem, const JointRows& start,
                                  const MovementOptions& options) {
  constexpr int kPatience = 2;      // steps that may go uphill
  constexpr double kFarUphill = 2;  // and how high, times the value below
  constexpr double kMostDamping = 1e12;
  Point now, next, left, over;  // `left` by a step uphill to `over`
  now.q = start;
  clamp(problem, now.q);
  evaluate(problem, now);

  BandCholesky hessian;
  hessian.resize(problem.frames, start.cols());
  const std::vector<Eigen::MatrixXd> between = difference_curvature(problem);
  JointRows step;
  JointVector damping = JointVector::Constant(now.q.rows(), 0.1);
  int uphill = 0, small = 0;
  MovementMinimum result;
  while (result.iterations < options.iterations && small < 2 &&
         damping.minCoeff() <= kMostDamping) {
    ++result.iterations;
    if (!short_step(problem, between, now, damping, hessian, step)) {
      damping *= 8;
      continue;
    }
    next.q = now.q + step;
    clamp(problem, next.q);
    evaluate(problem, next);
    const double before = uphill > 0 ? left.value : now.value;
    if (next.value < before) {
      small = before - next.value < options.relative_value * before ? small + 1 : 0;
      adapt(now, next, true, damping);
      std::swap(now, next);
      uphill = 0;
    } else if (uphill < kPatience && next.value < kFarUphill * before) {
      if (uphill++ == 0) {
        std::swap(left, now);
        over = next;
      }
      std::swap(now, next);
    } else {
      if (uphill > 0) {
        std::swap(now, left);
        std::swap(next, over);
      }
      adapt(now, next, false, damping);
      uphill = 0;
    }
  }
  if (uphill > 0) std::swap(now, left);
  result.converged = small == 2;
  result.q = now.q;
  result.value = now.value;
  result.frame_value = now.frame_value;
  return result;
}

}  // namespace morphe
