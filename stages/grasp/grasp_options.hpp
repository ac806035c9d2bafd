#pragma once

#include <string>

#include "core/motion/key_bounds.hpp"

namespace morphe::grasp {

/// Options for contacts with the object's surface (config section `grasp`).
struct GraspOptions {
  double pad_depth_m = 0.011;       ///< from a fingertip on the finger's axis to the skin
  double touch_distance_m = 0.010;  ///< distance from the surface at which skin touches it
  double min_contact_share = 0.5;   ///< smallest share of a tip's seen frames in which it touches
  double preshape_clearance_m = 0.005;  ///< of the skin from the object halfway to contact
  bool close_fingers = true;          ///< true if fingers without goals are closed onto the object
  double max_penetration_m = 0.001;   ///< of pads into the object; replaces check.max_penetration
  double max_link_penetration_m = 0;  ///< of the hand's other links
  double friction_coefficient = 0.8;
  double torsional_friction_m = 0.002;  ///< that of a pad with a contact radius of 4 mm
  double mass_kg = 0.3;                 ///< mass of the grasped object
  double max_finger_force = 8;          ///< force of the finger that presses most [N]
  double min_finger_force_share = 0.3;  ///< smallest share of that force for every finger
  double max_joint_torque = 1;          ///< torque limit of a finger's joint [N m]
  double joint_stiffness = 10;          ///< stiffness of the joint's servo [N m/rad]
};
template <class Fields>
void fields(Fields& f, GraspOptions& o) {
  f("pad_depth", o.pad_depth_m, bounds::kLength);
  f("touch_distance", o.touch_distance_m, bounds::kPositiveLength);
  f("min_contact_share", o.min_contact_share, bounds::kPositiveShare);
  f("preshape_clearance", o.preshape_clearance_m, bounds::kLength);
  f("close_fingers", o.close_fingers);
  f("max_penetration", o.max_penetration_m, bounds::kLength);
  f("max_link_penetration", o.max_link_penetration_m, bounds::kLength);
  f("friction_coefficient", o.friction_coefficient, bounds::kFriction);
  f("torsional_friction", o.torsional_friction_m, bounds::kLength);
  f("mass", o.mass_kg, bounds::kMass);
  f("max_finger_force", o.max_finger_force, bounds::kForce);
  f("min_finger_force_share", o.min_finger_force_share, bounds::kShareBelow1);
  f("max_joint_torque", o.max_joint_torque, bounds::kTorque);
  f("joint_stiffness", o.joint_stiffness, bounds::kStiffness);
}

}  // namespace morphe::grasp
