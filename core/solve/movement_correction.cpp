#include "core/solve/movement_correction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/solve/constants.hpp"

namespace morphe::solve {

using Eigen::Index;

JointVector model_error(const MovementPoint& begin, const JointRows& aimed,
                        const MovementPoint& end) {
  JointVector error(begin.q.rows()), step, bent;
  for (Index f = 0; f < begin.q.rows(); ++f) {
    const Quadratic& model = begin.models[f];
    step = (aimed.row(f) - begin.q.row(f)).transpose();
    bent.noalias() = model.hessian * step;
    error[f] = end.models[f].value - model.value - step.dot(model.gradient) - 0.5 * step.dot(bent);
  }
  return error;
}

void correct_step(const MovementProblem& problem, const DifferenceCurvature& between,
                  const MovementPoint& begin, const JointRows& aimed, const MovementPoint& end,
                  const JointVector& damping, JointRows& corrected) {
  corrected = end.q;
  JointVector step, change;
  Eigen::MatrixXd hessian;
  Eigen::LLT<Eigen::MatrixXd> factor;
  for (Index f = 0; f < end.q.rows(); ++f) {
    step = (aimed.row(f) - begin.q.row(f)).transpose();
    change = begin.models[f].gradient - end.models[f].gradient;
    change.noalias() += begin.models[f].hessian * step;
    hessian = end.models[f].hessian;
    hessian.diagonal() += between[f].col(0);
    hessian.diagonal().array() += std::max(damping[f], kMinCorrectionCurvature);
    for (Index j = 0; j < change.size(); ++j) {
      if (end.q(f, j) > problem.lower[j] && end.q(f, j) < problem.upper[j]) continue;
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
