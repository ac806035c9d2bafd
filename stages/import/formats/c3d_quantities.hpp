#pragma once

#include <string>
#include <vector>

#include "stages/import/formats/c3d_file.hpp"
#include "stages/import/formats/c3d_parameters.hpp"

namespace morphe::imports {

/// Returns the parameter that lists each label as a quantity that is no place, such as
/// "POINT:ANGLES", also ANGLES2, …; "" for a place. Programs that compute joint angles, forces,
/// moments and powers store them as points. Names are compared with and without "SUBJECT:".
std::vector<std::string> listed_quantities(const C3dParameters& parameters,
                                           const std::vector<std::string>& labels);

/// Removes the points with a quantity, and adds a note about them. Throws InputError if no other
/// point is left.
void remove_quantities(const C3dParameters& parameters, const std::vector<std::string>& quantities,
                       C3dPoints& points);

}  // namespace morphe::imports
