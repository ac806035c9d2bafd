#pragma once

#include <string>

namespace morphe::grasp {

/// Options for contacts with the object's surface (config section `grasp`).
struct GraspOptions {
  /// Distance from a person's fingertip (on the finger's axis) to the skin.
  double pad_depth_m = 0.011;
  double touch_distance_m = 0.010;  ///< distance from the surface at which skin touches it
  /// Least share of a tip's seen frames in grasp and hold in which it touches.
  double least_share = 0.5;
  /// Clearance of the skin from the object halfway to contact.
  double preshape_clearance_m = 0.005;
  bool close_fingers = true;  ///< true if fingers without goals are closed onto the object
  /// Allowed depth of pads in the object; replaces check.contact_depth.
  double contact_depth_m = 0.001;
  double link_depth_m = 0;      ///< allowed depth of the hand's other links in the object
  double friction = 0.8;        ///< friction coefficient
  double torsion_m = 0.002;     ///< torsional friction, that of a pad with a contact radius of 4 mm
  double mass_kg = 0.3;         ///< mass of the grasped object
  double squeeze_force = 8;     ///< force of the finger that presses most [N]
  double squeeze_share = 0.3;   ///< least share of that force for every finger
  double joint_torque = 1;      ///< torque limit of a finger's joint [N m]
  double joint_stiffness = 10;  ///< stiffness of the joint's servo [N m/rad]
};
template <class Fields>
void fields(Fields& f, GraspOptions& o) {
  f("pad_depth", o.pad_depth_m);
  f("near", o.touch_distance_m);
  f("least_share", o.least_share);
  f("aperture", o.preshape_clearance_m);
  f("close_fingers", o.close_fingers);
  f("penetration", o.contact_depth_m);
  f("link_penetration", o.link_depth_m);
  f("friction", o.friction);
  f("torsion", o.torsion_m);
  f("mass", o.mass_kg);
  f("squeeze_force", o.squeeze_force);
  f("squeeze_share", o.squeeze_share);
  f("joint_torque", o.joint_torque);
  f("joint_stiffness", o.joint_stiffness);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const GraspOptions& options);

}  // namespace morphe::grasp
