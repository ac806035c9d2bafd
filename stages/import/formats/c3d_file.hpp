#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The 3D points of a C3D file, in its own unit and axes.
struct C3dPoints {
  std::vector<std::string> labels;  ///< [K]
  std::string unit;                 ///< POINT:UNITS, "" if absent
  std::string x_screen, y_screen;   ///< POINT:X_SCREEN and Y_SCREEN, such as "+X"; "" if absent
  double rate_hz = 0;               ///< POINT:RATE, otherwise the header's
  std::size_t first_frame = 1;      ///< number of the first frame
  Array2D<Vec3> position;  ///< [N, K], NaN if not seen: residual below zero, or not a number
  std::vector<std::string> import_notes;  ///< disagreements of header, parameters and data
};

/// Reads header, parameters and points, not the analog samples. Intel, DEC and SGI processors,
/// floats and scaled integers are supported. Throws InputError "FILE: byte N: …" or "FILE:
/// POINT:KEY: …" for references outside the file, missing data and ambiguous points.
C3dPoints read_c3d_points(const std::filesystem::path& file);

}  // namespace morphe::imports
