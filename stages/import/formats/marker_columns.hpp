#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The columns of Vicon's CSV and TRC: leading ones, then X, Y and Z of each marker.
struct MarkerColumns {
  std::vector<std::string> leading;  ///< names of the columns before the first marker's
  std::vector<std::string> names;    ///< [K] of the markers

  std::size_t count() const { return leading.size() + 3 * names.size(); }  ///< of columns
  std::string name(std::size_t column) const;  ///< for messages: "RFTP.X"
};

/// Reads the markers' names in a line, each above the marker's X, after `leading` columns; trailing
/// empty cells are ignored, and repeated names numbered, with a note. Throws InputError for a name
/// elsewhere, a missing name, and a line without names.
std::vector<std::string> read_marker_names(const files::CsvText& csv, std::size_t line,
                                           std::size_t leading, std::vector<std::string>& notes);

/// Reads the markers in the `cells` of a line, times `metres`, into row `row` of `position`. A
/// missing value is NaN; the last markers of a row whose separators are blank may lack their cells,
/// which editors remove at the end of a line. Throws InputError for too few cells, text after the
/// last marker's cells, and a cell that is not a number.
void read_points(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const MarkerColumns& columns,
                 double metres, Array2D<Vec3>& position, std::size_t row);

}  // namespace morphe::imports
