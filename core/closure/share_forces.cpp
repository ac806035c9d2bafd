#include "core/closure/share_forces.hpp"

#include <algorithm>
#include <cassert>

#include "core/closure/barrier.hpp"
#include "core/closure/wrench_set.hpp"

namespace morphe::closure {
namespace {

constexpr double kBalance = 100, kEvenness = 1e-2, kFriction = 1e-3;
/// How far beyond the largest force the pulls go, so that what they press against is met closely.
constexpr double kBeyond = 2;

/// Unknowns: four a contact (normal force; both tangential forces over friction_use mu; the moment
/// over friction_use gamma), then the level, and what the residual is at most, all over
/// largest_n. So each cone is |y| <= f_n.
struct Unknowns {
  const ContactSet& contacts;
  WrenchSet set;
  double tangential, moment_m;  ///< what an unknown of 1 stands for

  Eigen::Index first(std::size_t contact) const { return 4 * static_cast<Eigen::Index>(contact); }
  Eigen::Index level() const { return first(set.cones.size()); }
  Eigen::Index rest() const { return level() + 1; }
  Eigen::Index count() const { return level() + 2; }
};

/// [6, unknowns]: the wrench of them.
Eigen::MatrixXd wrench_matrix(const Unknowns& unknowns) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6, unknowns.count());
  for (std::size_t k = 0; k < unknowns.set.cones.size(); ++k) {
    const WrenchSet::Cone& cone = unknowns.set.cones[k];
    const Eigen::Index at = unknowns.first(k);
    matrix.col(at) = wrench_of(cone.normal, cone.lever);
    matrix.col(at + 1) = unknowns.tangential * wrench_of(cone.across, cone.lever);
    matrix.col(at + 2) = unknowns.tangential * wrench_of(cone.along, cone.lever);
    matrix.col(at + 3).tail<3>() =
        unknowns.moment_m / unknowns.contacts.torque_scale_m * cone.normal;
  }
  return matrix;
}

/// 1/2 x^T H x + g^T x of all that is minimised; `load` is over largest_n.
void add_objective(const Unknowns& unknowns, const Wrench& load, BarrierProblem& problem) {
  problem.rest = wrench_matrix(unknowns);
  problem.rest_at_0 = load;
  problem.hessian = Eigen::MatrixXd::Zero(unknowns.count(), unknowns.count());
  problem.gradient = Eigen::VectorXd::Zero(unknowns.count());
  problem.gradient[unknowns.rest()] = kBalance;
  const Eigen::Index level = unknowns.level();
  problem.hessian(level, level) += 1;
  problem.gradient[level] -= kBeyond;
  for (std::size_t k = 0; k < unknowns.set.cones.size(); ++k) {
    const Eigen::Index at = unknowns.first(k);
    problem.hessian(at, at) += kEvenness;
    problem.hessian(level, level) += kBeyond * kBeyond * kEvenness;
    problem.hessian(at, level) -= kBeyond * kEvenness;
    problem.hessian(level, at) -= kBeyond * kEvenness;
    for (Eigen::Index j = 1; j < 4; ++j) problem.hessian(at + j, at + j) += kFriction;
  }
}

void add_bounds(const Unknowns& unknowns, const SqueezeOptions& options,
                const std::vector<ForceBound>& bounds, BarrierProblem& problem) {
  const auto n = static_cast<Eigen::Index>(unknowns.set.cones.size());
  problem.rows =
      Eigen::MatrixXd::Zero(2 * n + 1 + static_cast<Eigen::Index>(bounds.size()), unknowns.count());
  problem.most = Eigen::VectorXd::Zero(problem.rows.rows());
  for (Eigen::Index k = 0; k < n; ++k) {
    problem.rows(2 * k, 4 * k) = -1;  // share F <= f_n
    problem.rows(2 * k, unknowns.level()) = options.share;
    problem.rows(2 * k + 1, 4 * k) = 1;  // f_n <= F
    problem.rows(2 * k + 1, unknowns.level()) = -1;
  }
  problem.rows(2 * n, unknowns.level()) = 1;  // F <= 1
  problem.most[2 * n] = 1;
  Eigen::Index row = 2 * n + 1;
  for (const ForceBound& bound : bounds) {
    assert(bound.most > 0 && bound.force.size() == unknowns.set.cones.size() &&
           bound.moment.size() == unknowns.set.cones.size());
    for (std::size_t k = 0; k < bound.force.size(); ++k) {
      const WrenchSet::Cone& cone = unknowns.set.cones[k];
      const Eigen::Index at = unknowns.first(k);
      problem.rows(row, at) = bound.force[k].dot(cone.normal);
      problem.rows(row, at + 1) = unknowns.tangential * bound.force[k].dot(cone.across);
      problem.rows(row, at + 2) = unknowns.tangential * bound.force[k].dot(cone.along);
      problem.rows(row, at + 3) = unknowns.moment_m * bound.moment[k];
    }
    problem.most[row++] = bound.most / options.largest_n;
  }
}

/// All contacts press alike, without friction, with so little that no bound is near.
Eigen::VectorXd small_start(const Unknowns& unknowns, double share, const BarrierProblem& problem) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns.count());
  x[unknowns.level()] = 1;
  for (std::size_t k = 0; k < unknowns.set.cones.size(); ++k) {
    x[unknowns.first(k)] = 0.5 * (1 + share);
  }
  double size = 0.5;
  for (Eigen::Index row = 0; row < problem.rows.rows(); ++row) {
    const double taken = problem.rows.row(row).dot(x);
    if (problem.most[row] > 0 && taken > 0) size = std::min(size, 0.5 * problem.most[row] / taken);
  }
  x *= size;
  x[unknowns.rest()] = 1 + 2 * (problem.rest * x + problem.rest_at_0).norm();
  return x;
}

}  // namespace

Squeeze share_forces(const ContactSet& contacts, const Wrench& load, const SqueezeOptions& options,
                     const std::vector<ForceBound>& bounds) {
  assert(options.largest_n > 0 && options.share >= 0 && options.share < 1);
  assert(options.friction_use > 0 && options.friction_use <= 1);
  Squeeze squeeze;
  squeeze.residual = load;
  squeeze.converged = true;
  if (contacts.contacts.empty()) return squeeze;
  const Unknowns unknowns{contacts, make_wrench_set(contacts, ForceLimit::each),
                          options.friction_use * contacts.friction.mu,
                          options.friction_use * contacts.friction.gamma_m};
  BarrierProblem problem;
  problem.cones = static_cast<Eigen::Index>(unknowns.set.cones.size());
  add_objective(unknowns, load / options.largest_n, problem);
  add_bounds(unknowns, options, bounds, problem);
  Eigen::VectorXd x = small_start(unknowns, options.share, problem);
  squeeze.converged = minimise_inside(problem, x);

  squeeze.least_n = kInfinity;
  for (std::size_t k = 0; k < unknowns.set.cones.size(); ++k) {
    const WrenchSet::Cone& cone = unknowns.set.cones[k];
    const Eigen::Vector4d at = options.largest_n * x.segment<4>(unknowns.first(k));
    ContactForce force;
    force.force =
        at[0] * cone.normal + unknowns.tangential * (at[1] * cone.across + at[2] * cone.along);
    force.moment_nm = unknowns.moment_m * at[3];
    squeeze.residual += wrench_of(force.force, cone.lever);
    squeeze.residual.tail<3>() += force.moment_nm / contacts.torque_scale_m * cone.normal;
    squeeze.largest_n = std::max(squeeze.largest_n, at[0]);
    squeeze.least_n = std::min(squeeze.least_n, at[0]);
    squeeze.forces.push_back(force);
  }
  return squeeze;
}

ForceBound presses_at_most(const ContactSet& contacts, std::size_t contact, double newtons) {
  ForceBound bound;
  bound.force.assign(contacts.contacts.size(), Vec3::Zero());
  bound.moment.assign(contacts.contacts.size(), 0);
  bound.force[contact] = contacts.contacts[contact].normal;
  bound.most = newtons;
  return bound;
}

}  // namespace morphe::closure
