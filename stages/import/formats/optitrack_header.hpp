#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// One thing in a take and where its numbers stand: columns of X, Y, Z (and W).
struct OptitrackItem {
  std::string type;                   ///< "Rigid Body", "Rigid Body Marker", "Marker", "Bone", …
  std::string name;                   ///< "Box", "Box:Marker1"
  std::vector<std::size_t> position;  ///< 3, or none
  std::vector<std::size_t> rotation;  ///< 4 of a quaternion x, y, z, w; 3 of Euler angles; or none
};

/// The header of a take that Motive exported as CSV.
struct OptitrackHeader {
  std::map<std::string, std::string, std::less<>> said;  ///< line 1: "Length Units", …
  std::vector<OptitrackItem> items;
  std::size_t line = 0;   ///< of "Frame,Time…"; rows follow
  std::size_t cells = 0;  ///< of a row

  /// "" if line 1 does not say it.
  std::string value(const std::string& key) const;
};

/// Columns are told by what stands above them, not by their place or the file's version. InputError
/// for a file without these lines, poses relative to other bodies (Coordinate Space Local) and
/// a position or rotation that lacks a column.
OptitrackHeader read_optitrack_header(const files::CsvText& csv);

}  // namespace morphe::imports
