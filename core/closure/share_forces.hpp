#pragma once

#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// What a contact does to the object, in the object's frame.
struct ContactForce {
  Vec3 force = Vec3::Zero();  ///< [N]
  double moment_nm = 0;       ///< about the contact's normal [N m]
};

/// sum_i force_row_i · force_i + moment_i · moment_nm_i <= most, with most > 0: what a joint can
/// give, a row of J^T against its torque limit (and one with the signs turned for the other side),
/// or what a finger may press with.
struct ForceBound {
  std::vector<Vec3> force;     ///< one per contact
  std::vector<double> moment;  ///< one per contact [1/m]
  double most = 0;
};

struct SqueezeOptions {
  double largest_n = 5;  ///< normal force of the contact that presses most [N], > 0
  double share = 0.3;    ///< of the largest, which every contact presses with at least; in [0, 1)
  double friction_use = 0.7;  ///< of the cone, which forces stay inside of; in (0, 1]
};

/// Forces that balance a load, shared so that every contact bears its part.
struct Squeeze {
  std::vector<ContactForce> forces;  ///< one per contact
  double largest_n = 0;              ///< normal force [N]; less than asked for where that cannot be
  double least_n = 0;                ///< normal force of the contact that presses least [N]
  Wrench residual = Wrench::Zero();  ///< of load and forces together [N]
  bool converged = false;  ///< false: the steps were used up before the accuracy was reached
};

/// Over the forces (f_n, f_t, m) of the contacts and the level F, in units of largest_n,
///   minimises 100 |residual| + 1/2 (2 - F)^2 + 0.005 sum (2 F - f_n)^2
///                                           + 0.0005 sum (|f_t|^2 / mu^2 + m^2 / gamma^2)
///   subject to share F <= f_n <= F <= 1, cones of friction_use times mu and gamma, and the bounds:
/// balance comes first, then as much force as asked for, then evenness, then little use of
/// friction. What cannot be balanced at these shares ends with hardly any force, or with a
/// residual. A barrier method (barrier.hpp), accurate to 1e-4 of largest_n, the residual to 1e-7.
/// `load` is what acts on the object besides, torques over the torque scale [N].
Squeeze share_forces(const ContactSet& contacts, const Wrench& load, const SqueezeOptions& options,
                     const std::vector<ForceBound>& bounds = {});

/// f_n of one contact is at most `newtons`.
ForceBound presses_at_most(const ContactSet& contacts, std::size_t contact, double newtons);

}  // namespace morphe::closure
