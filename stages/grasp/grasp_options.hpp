#pragma once

#include <string>

namespace morphe::grasp {

/// Contacts instead of points near the object (config section `grasp`).
struct GraspOptions {
  double pad_depth_m = 0.011;     ///< from a person's fingertip (the finger's axis) to the skin
  double near_m = 0.010;          ///< skin this near to the surface touches it
  double least_share = 0.5;       ///< of a tip's seen frames in grasp and hold in which it touches
  double aperture_m = 0.005;      ///< skin keeps this far from the object halfway to it
  bool close_fingers = true;      ///< fingers without goals are closed onto the object
  double penetration_m = 0.001;   ///< of pads into the object; takes check.contact_depth's place
  double link_penetration_m = 0;  ///< of other links of the hand into it
  double friction = 0.8;          ///< coefficient
  double torsion_m = 0.002;       ///< torsional friction, of a pad with a contact radius of 4 mm
  double mass_kg = 0.3;           ///< of what is grasped
  double squeeze_force = 8;       ///< of the finger that presses most [N]
  double squeeze_share = 0.3;     ///< of that, with which every finger presses at least
  double joint_torque = 1;        ///< that a finger's joint can bear [N m]
  double joint_stiffness = 10;    ///< of its servo [N m/rad]
};
template <class Fields>
void fields(Fields& f, GraspOptions& o) {
  f("pad_depth", o.pad_depth_m);
  f("near", o.near_m);
  f("least_share", o.least_share);
  f("aperture", o.aperture_m);
  f("close_fingers", o.close_fingers);
  f("penetration", o.penetration_m);
  f("link_penetration", o.link_penetration_m);
  f("friction", o.friction);
  f("torsion", o.torsion_m);
  f("mass", o.mass_kg);
  f("squeeze_force", o.squeeze_force);
  f("squeeze_share", o.squeeze_share);
  f("joint_torque", o.joint_torque);
  f("joint_stiffness", o.joint_stiffness);
}
std::string why_invalid(const GraspOptions& options);

}  // namespace morphe::grasp
