#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// An item of a take with its columns of X, Y, Z (and W).
struct OptitrackItem {
  std::string type;                   ///< "Rigid Body", "Rigid Body Marker", "Marker", "Bone", …
  std::string name;                   ///< "Box", "Box:Marker1"
  std::vector<std::size_t> position;  ///< 3, or empty
  std::vector<std::size_t> rotation;  ///< 4 of a quaternion x, y, z, w; 3 of Euler angles; or empty
};

/// The header of a take that Motive exported as CSV.
struct OptitrackHeader {
  std::map<std::string, std::string, std::less<>> settings;  ///< line 1: "Length Units", …
  std::vector<OptitrackItem> items;                          ///< in the order of their columns
  std::size_t line = 0;                                      ///< of "Frame,Time…"; rows follow
  std::size_t cells = 0;                                     ///< number of cells in a row

  std::string value(const std::string& key) const;  ///< "" if absent in line 1
};

/// Reads the header. Columns are identified by the lines above them, independent of their position
/// and the file's version. Throws InputError for a file without these lines, poses relative to
/// other bodies (Coordinate Space Local) and a position or rotation with a missing column.
OptitrackHeader read_optitrack_header(const files::CsvText& csv);

}  // namespace morphe::imports
