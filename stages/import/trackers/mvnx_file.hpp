#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// Segments of a body or a hand, each at its proximal joint [m], in the file's axes.
struct MvnxSegments {
  std::vector<std::string> labels;   ///< [S]
  std::map<std::string, Vec3> tips;  ///< position of a fingertip in its segment [m], by label
  Array2D<Vec3> position;            ///< [N, S]
  Array2D<Quat> orientation;         ///< [N, S]
};

/// The contents of an MVNX file of Xsens, without the frames of the calibration.
struct MvnxFile {
  std::string subject;
  std::vector<double> time;               ///< [N] [s]
  MvnxSegments body;                      ///< segments of the body
  std::array<MvnxSegments, 2> fingers;    ///< by Side; without labels if there is no glove
  std::vector<std::string> import_notes;  ///< assumptions and repairs
};

/// Reads an MVNX file. `rate_hz` replaces the file's rate if above 0. Throws InputError with the
/// line for missing data, text in place of numbers, and a wrong number of them.
MvnxFile read_mvnx_file(const std::filesystem::path& file, double rate_hz);

}  // namespace morphe::imports
