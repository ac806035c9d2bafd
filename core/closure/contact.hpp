#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::closure {

/// A force [N] and the torque about the reference point, divided by the torque scale [N]. Twists,
/// the dual vectors of wrenches, have the same type: u·w with u = (u_f, u_t).
using Wrench = Eigen::Matrix<double, 6, 1>;
/// Up to seven wrenches as columns; with this maximum Eigen compiles one factorisation for all.
using WrenchColumns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 7>;

/// A contact of a finger with the object, in the object's frame.
struct Contact {
  Vec3 point;   ///< on the surface [m]
  Vec3 normal;  ///< unit vector into the object, the direction of the finger's force
  double force_limit_share = 1;  ///< for ForceLimit::each: limit of its normal force
};

/// The friction of a soft finger with an elliptic cone: |f_t|^2 / mu^2 + m^2 / gamma^2 <= f_n^2 for
/// the tangential force f_t and the moment m about the normal. gamma_m = 0 is a hard contact
/// without moment.
struct Friction {
  double mu = 0;
  double gamma_m = 0;  ///< moment per normal force [m]
};

/// The contacts of a grasp, and the scaling of torques relative to forces.
struct ContactSet {
  std::vector<Contact> contacts;
  Friction friction;
  Vec3 reference = Vec3::Zero();  ///< reference point of torques: the centre of mass, if known [m]
  double torque_scale_m = 1;      ///< largest distance of the surface from the reference [m]
};

/// Returns the reason why a set is invalid (a normal that is not a unit vector, negative friction,
/// a scale or a share that is not positive, a value that is not a number), "" if it is valid. The
/// functions of this folder require a valid set.
std::string validation_error(const ContactSet& set);

/// Returns r = (p - c) / rho of the contact's point p, the reference c and the torque scale rho.
inline Vec3 moment_arm(const ContactSet& set, const Contact& contact) {
  return (contact.point - set.reference) / set.torque_scale_m;
}

/// Returns the wrench (f, r × f) of a force at a contact, from the arm r already divided by rho.
inline Wrench wrench_of(const Vec3& force, const Vec3& scaled_arm) {
  Wrench wrench;
  wrench << force, scaled_arm.cross(force);
  return wrench;
}

}  // namespace morphe::closure
