#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The 3D points of a C3D file, as they stand there: own unit, own axes.
struct C3dPoints {
  std::vector<std::string> labels;  ///< [K]
  std::string unit;                 ///< POINT:UNITS, "" if absent
  std::string x_screen, y_screen;   ///< POINT:X_SCREEN and Y_SCREEN, such as "+X"; "" if absent
  double rate_hz = 0;               ///< POINT:RATE, else the header's
  std::size_t first_frame = 1;
  Table<Vec3> position;              ///< [N, K], NaN = not seen: residual below zero, or no number
  std::vector<std::string> reports;  ///< where header, parameters and data disagree
};

/// Reads header, parameters and points; analog samples are passed over. Intel, DEC and SGI
/// processors, floats and scaled integers. InputError "FILE: byte N: …" or "FILE: POINT:KEY: …" for
/// anything that leads outside the file, is missing, or contradicts itself such that points cannot
/// be told from each other.
C3dPoints read_c3d_points(const std::filesystem::path& file);

}  // namespace morphe::imports
