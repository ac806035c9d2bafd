#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The marker columns of Vicon's CSV and TRC: two leading columns, then X, Y and Z of each marker,
/// whose name is above its X.
struct MarkerColumns {
  static constexpr std::size_t kLeadingCount = 2;  ///< columns before the first marker's
  std::string leading[kLeadingCount];              ///< names of the first two columns
  std::vector<std::string> names;                  ///< [K]

  /// Returns the number of columns.
  std::size_t count() const { return kLeadingCount + 3 * names.size(); }
  std::string name(std::size_t column) const;  ///< name for messages: "RFTP.X"
};

/// Reads the names in a line; trailing empty cells are ignored. Throws InputError for a name in
/// another column, a marker without a name, a repeated name, and a line without names.
std::vector<std::string> read_marker_names(const files::CsvText& csv, std::size_t line);

/// Reads a marker's three cells of a row, times `metres`. An empty cell, or NaN in all three, means
/// not seen. Throws InputError for a row with too few cells or text after the last marker's, a cell
/// that is not a number, and a marker with some of X, Y, Z but not all.
void read_points(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const MarkerColumns& columns,
                 double metres, Array2D<Vec3>& position, std::size_t row);

}  // namespace morphe::imports
