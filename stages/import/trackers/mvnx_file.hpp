#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {

/// Segments of a body or a hand, each at its proximal joint [m], in the file's axes.
struct MvnxSegments {
  std::vector<std::string> labels;   ///< [S]
  std::map<std::string, Vec3> tips;  ///< by label, the position of a fingertip in its segment [m]
  Array2D<Vec3> position;            ///< [N, S]
  Array2D<Quat> orientation;         ///< [N, S]
};

/// An MVNX file of Xsens, with its frames of motion, without those of the calibration.
struct MvnxFile {
  std::string file, subject;
  std::vector<double> time;               ///< [N] [s]
  MvnxSegments body;                      ///< segments of the body
  std::array<MvnxSegments, 2> fingers;    ///< by Side; without labels if there is no glove
  std::vector<std::string> import_notes;  ///< assumptions and repairs
};

/// Reads an MVNX file. `rate_hz` takes precedence over the file's (0 for the file's). Throws
/// InputError with the line if data are missing, not numbers, or not as many as the segments
/// require.
MvnxFile read_mvnx_file(const std::filesystem::path& file, double rate_hz);

}  // namespace morphe::imports
