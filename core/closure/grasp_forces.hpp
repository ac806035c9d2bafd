#pragma once

#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// The force and moment that a contact exerts on the object, in the object's frame.
struct ContactForce {
  Vec3 force = Vec3::Zero();  ///< [N]
  double moment_nm = 0;       ///< about the contact's normal [N m]
};

/// The constraint sum_i force[i] · f_i + moment[i] m_i <= upper_bound, above 0, on the contacts'
/// forces [N] and moments [N m]. It is the torque limit of a joint, with a row of J^T (and a second
/// one with opposite signs for the other direction), or the force limit of a finger.
struct ForceBound {
  std::vector<Vec3> force;     ///< one per contact [unit of upper_bound per N]
  std::vector<double> moment;  ///< one per contact [unit of upper_bound per N m]
  double upper_bound = 0;
};

/// The options of distribute_grasp_forces().
struct GraspForceOptions {
  double max_force_n = 5;            ///< largest normal force of a contact, > 0
  double min_force_share = 0.3;      ///< smallest normal force relative to the largest, in [0, 1)
  double friction_cone_share = 0.7;  ///< used share of mu and gamma, in (0, 1]
};

/// Contact forces that balance a load, distributed such that every contact bears a share of it.
struct GraspForces {
  std::vector<ContactForce> forces;  ///< one per contact
  double max_force_n = 0;            ///< largest normal force; below the options' if infeasible
  double min_force_n = 0;            ///< smallest normal force
  Wrench residual = Wrench::Zero();  ///< sum of the load and the contact forces [N]
  bool converged = false;  ///< false if the iterations ended before the accuracy was reached
};

/// Computes the forces (f_n, f_t, m) of the contacts and the level F, in units of max_force_n. With
/// s = friction_cone_share, it minimises
///   100 |residual| + 1/2 (2 - F)^2 + 0.005 sum (2 F - f_n)^2
///                  + 0.0005 sum (|f_t|^2 / mu^2 + m^2 / gamma^2) / s^2
/// subject to min_force_share F <= f_n <= F <= 1, cones of s mu and s gamma, and the bounds.
/// The priorities are, in this order: balance, the requested force level, equal normal forces, and
/// little use of friction. A load that cannot be balanced at these shares gives very small forces
/// or a residual. The barrier method (barrier.hpp) is accurate to 1e-4 of max_force_n, the residual
/// to 1e-7. `load` is the external wrench on the object, with torques divided by the torque scale
/// [N].
GraspForces distribute_grasp_forces(const ContactSet& contacts, const Wrench& load,
                                    const GraspForceOptions& options,
                                    const std::vector<ForceBound>& bounds = {});

}  // namespace morphe::closure
