#pragma once

#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::closure {

/// A force [N] and the torque about the reference point, divided by the torque scale [N]. Twists,
/// which weigh wrenches, are of the same type: u·w with u = (u_f, u_t).
using Wrench = Eigen::Matrix<double, 6, 1>;
/// Up to seven wrenches as columns. Its size is a type of its own, so that Eigen compiles one
/// factorization for all who solve with such columns.
using WrenchColumns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 7>;

/// Where a finger presses, in the object's frame.
struct Contact {
  Vec3 point;   ///< on the surface [m]
  Vec3 normal;  ///< unit, into the object: the way the finger presses
  /// Of ForceLimit::each: the limit of its normal force, as a share of that of a contact of 1.
  double share = 1;
};

/// A soft finger with an elliptic cone: |f_t|^2 / mu^2 + m^2 / gamma^2 <= f_n^2 for the tangential
/// force f_t and the moment m about the normal. gamma_m = 0 is a hard contact without moment.
struct Friction {
  double mu = 0;
  double gamma_m = 0;  ///< moment per normal force [m]
};

/// The contacts of one grasp, and how forces and torques are measured against each other.
struct ContactSet {
  std::vector<Contact> contacts;
  Friction friction;
  Vec3 reference = Vec3::Zero();  ///< torques are about it: the centre of mass, if known [m]
  double torque_scale_m = 1;      ///< the surface's largest distance from it [m]
};

/// What is wrong with it (a normal that is no unit vector, friction below 0, a scale or a share
/// that is not above 0, a number that is none), "" if nothing. The functions of this folder assume
/// nothing is.
std::string why_invalid(const ContactSet& set);

/// r = (p - c) / rho.
inline Vec3 lever(const ContactSet& set, const Contact& contact) {
  return (contact.point - set.reference) / set.torque_scale_m;
}

/// (f, r × f) of a force at a contact.
inline Wrench wrench_of(const Vec3& force, const Vec3& lever) {
  Wrench wrench;
  wrench << force, lever.cross(force);
  return wrench;
}

}  // namespace morphe::closure
