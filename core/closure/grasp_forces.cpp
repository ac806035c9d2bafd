#include "core/closure/grasp_forces.hpp"

#include <algorithm>
#include <cassert>

#include "core/closure/barrier.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {
namespace {

constexpr double kResidualWeight = 100, kEvennessWeight = 1e-2, kFrictionWeight = 1e-3;
/// Target of F, and of f_n / F: above their bounds of 1, so that these are closely reached.
constexpr double kForceTargetRatio = 2;

/// The unknowns: four per contact (normal force; both tangential forces divided by
/// friction_cone_share mu; the moment divided by friction_cone_share gamma), then the level, and
/// the bound of the residual, all divided by max_force_n. Each cone is thus |y| <= f_n.
struct Unknowns {
  const ContactSet& contacts;
  WrenchSet set;
  double tangential, moment_m;  ///< value of an unknown of 1

  Eigen::Index first(Eigen::Index contact) const { return 4 * contact; }
  Eigen::Index level() const { return first(std::ssize(set.cones)); }
  Eigen::Index residual_bound() const { return level() + 1; }
  Eigen::Index count() const { return level() + 2; }
};

/// Returns the matrix [6, unknowns] that maps the unknowns to their wrench.
Eigen::MatrixXd wrench_matrix(const Unknowns& unknowns) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, unknowns.count());
  for (int k = 0; k < std::ssize(unknowns.set.cones); ++k) {
    const WrenchSet::Cone& cone = unknowns.set.cones[k];
    const Eigen::Index first = unknowns.first(k);
    matrix.col(first) = wrench_of(cone.normal, cone.scaled_arm);
    matrix.col(first + 1) = unknowns.tangential * wrench_of(cone.tangent_a, cone.scaled_arm);
    matrix.col(first + 2) = unknowns.tangential * wrench_of(cone.tangent_b, cone.scaled_arm);
    matrix.col(first + 3).tail<3>() =
        unknowns.moment_m / unknowns.contacts.torque_scale_m * cone.normal;
  }
  return matrix;
}

/// Sets the objective 1/2 x^T H x + g^T x and the residual; `load` is divided by max_force_n.
void add_objective(const Unknowns& unknowns, const Wrench& load, BarrierProblem& problem) {
  problem.residual_matrix = wrench_matrix(unknowns);
  problem.residual_offset = load;
  problem.hessian = Eigen::MatrixXd::Zero(unknowns.count(), unknowns.count());
  problem.gradient = Eigen::VectorXd::Zero(unknowns.count());
  problem.gradient[unknowns.residual_bound()] = kResidualWeight;
  const Eigen::Index level = unknowns.level();
  problem.hessian(level, level) += 1;
  problem.gradient[level] -= kForceTargetRatio;
  for (int k = 0; k < std::ssize(unknowns.set.cones); ++k) {
    const Eigen::Index first = unknowns.first(k);
    problem.hessian(first, first) += kEvennessWeight;
    problem.hessian(level, level) += kForceTargetRatio * kForceTargetRatio * kEvennessWeight;
    problem.hessian(first, level) -= kForceTargetRatio * kEvennessWeight;
    problem.hessian(level, first) -= kForceTargetRatio * kEvennessWeight;
    for (int j = 1; j < 4; ++j) problem.hessian(first + j, first + j) += kFrictionWeight;
  }
}

void add_bounds(const Unknowns& unknowns, const GraspForceOptions& options,
                const std::vector<ForceBound>& bounds, BarrierProblem& problem) {
  const Eigen::Index n = std::ssize(unknowns.set.cones);
  problem.rows = Eigen::MatrixXd::Zero(2 * n + 1 + std::ssize(bounds), unknowns.count());
  problem.row_bounds = Eigen::VectorXd::Zero(problem.rows.rows());
  for (Eigen::Index k = 0; k < n; ++k) {
    problem.rows(2 * k, 4 * k) = -1;  // share F <= f_n
    problem.rows(2 * k, unknowns.level()) = options.min_force_share;
    problem.rows(2 * k + 1, 4 * k) = 1;  // f_n <= F
    problem.rows(2 * k + 1, unknowns.level()) = -1;
  }
  problem.rows(2 * n, unknowns.level()) = 1;  // F <= 1
  problem.row_bounds[2 * n] = 1;
  Eigen::Index row = 2 * n + 1;
  for (const ForceBound& bound : bounds) {
    assert(bound.upper_bound > 0 && std::ssize(bound.force) == n && std::ssize(bound.moment) == n);
    for (int k = 0; k < n; ++k) {
      const WrenchSet::Cone& cone = unknowns.set.cones[k];
      const Eigen::Index first = unknowns.first(k);
      problem.rows(row, first) = bound.force[k].dot(cone.normal);
      problem.rows(row, first + 1) = unknowns.tangential * bound.force[k].dot(cone.tangent_a);
      problem.rows(row, first + 2) = unknowns.tangential * bound.force[k].dot(cone.tangent_b);
      problem.rows(row, first + 3) = unknowns.moment_m * bound.moment[k];
    }
    problem.row_bounds[row++] = bound.upper_bound / options.max_force_n;
  }
}

/// Returns equal normal forces without friction, small enough to be far from all bounds.
Eigen::VectorXd feasible_start(const Unknowns& unknowns, double share,
                               const BarrierProblem& problem) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns.count());
  x[unknowns.level()] = 1;
  for (int k = 0; k < std::ssize(unknowns.set.cones); ++k) x[unknowns.first(k)] = 0.5 * (1 + share);
  double scale = 0.5;
  for (Eigen::Index row = 0; row < problem.rows.rows(); ++row) {
    const double row_value = problem.rows.row(row).dot(x);
    if (problem.row_bounds[row] > 0 && row_value > 0)
      scale = std::min(scale, 0.5 * problem.row_bounds[row] / row_value);
  }
  x *= scale;
  x[unknowns.residual_bound()] =
      1 + 2 * (problem.residual_matrix * x + problem.residual_offset).norm();
  return x;
}

}  // namespace

GraspForces distribute_grasp_forces(const ContactSet& contacts, const Wrench& load,
                                    const GraspForceOptions& options,
                                    const std::vector<ForceBound>& bounds) {
  assert(options.max_force_n > 0 && options.min_force_share >= 0 && options.min_force_share < 1);
  assert(options.friction_cone_share > 0 && options.friction_cone_share <= 1);
  GraspForces squeeze;
  squeeze.residual = load;
  squeeze.converged = true;
  if (contacts.contacts.empty()) return squeeze;
  const Unknowns unknowns{contacts, make_wrench_set(contacts, ForceLimit::each),
                          options.friction_cone_share * contacts.friction.mu,
                          options.friction_cone_share * contacts.friction.gamma_m};
  BarrierProblem problem;
  problem.cones = std::ssize(unknowns.set.cones);
  add_objective(unknowns, load / options.max_force_n, problem);
  add_bounds(unknowns, options, bounds, problem);
  Eigen::VectorXd x = feasible_start(unknowns, options.min_force_share, problem);
  squeeze.converged = minimise_with_barrier(problem, x);

  squeeze.min_force_n = kInfinity;
  for (int k = 0; k < std::ssize(unknowns.set.cones); ++k) {
    const WrenchSet::Cone& cone = unknowns.set.cones[k];
    const Eigen::Vector4d y = options.max_force_n * x.segment<4>(unknowns.first(k));
    ContactForce force;
    force.force =
        y[0] * cone.normal + unknowns.tangential * (y[1] * cone.tangent_a + y[2] * cone.tangent_b);
    force.moment_nm = unknowns.moment_m * y[3];
    squeeze.residual += wrench_of(force.force, cone.scaled_arm);
    squeeze.residual.tail<3>() += force.moment_nm / contacts.torque_scale_m * cone.normal;
    squeeze.max_force_n = std::max(squeeze.max_force_n, y[0]);
    squeeze.min_force_n = std::min(squeeze.min_force_n, y[0]);
    squeeze.forces.push_back(force);
  }
  return squeeze;
}

}  // namespace morphe::closure
