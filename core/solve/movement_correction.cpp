#include "core/solve/movement_correction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace morphe::solve {

using Eigen::Index;

JointVector model_error(const MovementPoint& from, const JointRows& aimed,
                        const MovementPoint& to) {
  JointVector wrong(from.q.rows()), step, bent;
  for (Index f = 0; f < from.q.rows(); ++f) {
    const auto frame = static_cast<std::size_t>(f);
    const Quadratic& model = from.models[frame];
    step = (aimed.row(f) - from.q.row(f)).transpose();
    bent.noalias() = model.hessian * step;
    wrong[f] =
        to.models[frame].value - model.value - step.dot(model.gradient) - 0.5 * step.dot(bent);
  }
  return wrong;
}

void correct_step(const MovementProblem& problem, const DifferenceCurvature& between,
                  const MovementPoint& from, const JointRows& aimed, const MovementPoint& to,
                  const JointVector& damping, JointRows& corrected) {
  constexpr double kMinCurvature = 10;
  corrected = to.q;
  JointVector step, change;
  Eigen::MatrixXd hessian;
  Eigen::LLT<Eigen::MatrixXd> factor;
  for (Index f = 0; f < to.q.rows(); ++f) {
    const auto frame = static_cast<std::size_t>(f);
    step = (aimed.row(f) - from.q.row(f)).transpose();
    change = from.models[frame].gradient - to.models[frame].gradient;
    change.noalias() += from.models[frame].hessian * step;
    hessian = to.models[frame].hessian;
    hessian.diagonal() += between[frame].col(0);
    hessian.diagonal().array() += std::max(damping[f], kMinCurvature);
    for (Index j = 0; j < change.size(); ++j) {
      if (to.q(f, j) > problem.lower[j] && to.q(f, j) < problem.upper[j]) continue;
      hessian.row(j).setZero();
      hessian.col(j).setZero();
      hessian(j, j) = 1;
      change[j] = 0;
    }
    factor.compute(hessian);
    if (factor.info() != Eigen::Success) continue;
    factor.solveInPlace(change);
    corrected.row(f) += change.transpose();
  }
}

}  // namespace morphe::solve
