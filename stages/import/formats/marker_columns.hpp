#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// Markers as Vicon's CSV and TRC write them: two columns of their own, then X, Y and Z of each
/// marker, whose name stands above its X.
struct MarkerColumns {
  static constexpr std::size_t kFirst = 2;
  std::string leading[kFirst];     ///< what the first two columns are called
  std::vector<std::string> names;  ///< [K]

  std::size_t count() const { return kFirst + 3 * names.size(); }
  std::string name(std::size_t column) const;  ///< for messages: "RFTP.X"
};

/// The names of a line, empty cells behind the last one aside. InputError for one where no marker
/// begins, a marker without one, a name that stands twice, and none at all.
std::vector<std::string> read_marker_names(const files::CsvText& csv, std::size_t line);

/// A marker's three cells of a row, times `metres`. No cell, or NaN in all three, was not seen.
/// InputError for a row with too few cells or text behind the last marker's, a cell that is no
/// number, and a marker with some of X, Y, Z but not all.
void read_points(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const MarkerColumns& columns,
                 double metres, Table<Vec3>& position, std::size_t row);

}  // namespace morphe::imports
