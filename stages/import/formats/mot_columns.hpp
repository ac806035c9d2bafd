#pragma once

#include <string>
#include <string_view>

namespace morphe::imports {

/// Returns the quantities of an OpenSim file whose first line, its title, names a result without
/// joint angles: "muscle forces or activations" for "Static Optimization"; "" for other titles.
std::string mot_contents(std::string_view title);

/// Returns the quantity in a column that is no joint angle: "translations" (pelvis_tx), "forces and
/// moments" (ground_force_vx, elbow_flexion_moment), "muscle states" (…/activation), "speeds"
/// (…/speed, …_u), "positions" (cop_x, center_of_mass), "rotations of bodies"
/// (humerus_Ox); "" for a joint angle.
std::string mot_quantity(std::string_view column);

/// Returns the joint of a column: elbow_flexion of "/jointset/elbow/elbow_flexion/value".
std::string mot_joint(const std::string& column);

}  // namespace morphe::imports
