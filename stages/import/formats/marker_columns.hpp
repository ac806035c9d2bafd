#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The columns of Vicon's CSV and TRC: two leading ones, then X, Y and Z of each marker.
struct MarkerColumns {
  static constexpr std::size_t kLeadingCount = 2;  ///< columns before the first marker's
  std::string leading[kLeadingCount];              ///< names of these columns
  std::vector<std::string> names;                  ///< [K] of the markers

  std::size_t count() const { return kLeadingCount + 3 * names.size(); }  ///< of columns
  std::string name(std::size_t column) const;  ///< for messages: "RFTP.X"
};

/// Returns true if some coordinates of a point are NaN, but not all.
inline bool is_partial(const Vec3& point) { return point.hasNaN() && !point.array().isNaN().all(); }

/// Reads the markers' names in a line, each above the marker's X; trailing empty cells are ignored.
/// Throws InputError for a name elsewhere, a missing or repeated name, and a line without names.
std::vector<std::string> read_marker_names(const files::CsvText& csv, std::size_t line);

/// Reads the markers in the `cells` of a line, times `metres`, into row `row` of `position`. Three
/// cells that are empty or NaN mean not seen. Throws InputError for too few cells, text after the
/// last marker's cells, a cell that is not a number, and a marker with only some of X, Y, Z.
void read_points(const files::CsvText& csv, std::size_t line,
                 const std::vector<std::string_view>& cells, const MarkerColumns& columns,
                 double metres, Array2D<Vec3>& position, std::size_t row);

}  // namespace morphe::imports
