#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {

/// Segments of a body or a hand, each at the joint where it begins [m], in the file's axes.
struct MvnxSegments {
  std::vector<std::string> labels;   ///< [S]
  std::map<std::string, Vec3> tips;  ///< by label, where a fingertip lies in its segment [m]
  Table<Vec3> position;              ///< [N, S]
  Table<Quat> orientation;           ///< [N, S]
};

/// An MVNX file of Xsens: those of its frames that are motion, not calibration.
struct MvnxFile {
  std::string file, subject;
  std::vector<double> time;  ///< [N] [s]
  MvnxSegments body;
  std::array<MvnxSegments, 2> fingers;  ///< by Side; no labels = without a glove
  std::vector<std::string> reports;
};

/// `rate_hz` comes before the file's (0 = the file's). InputError with the line of what is missing,
/// no number, or not as often there as the segments ask for.
MvnxFile read_mvnx_file(const std::filesystem::path& file, double rate_hz);

}  // namespace morphe::imports
