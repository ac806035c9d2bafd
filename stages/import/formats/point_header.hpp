#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// The columns of a point in a table.
struct PointColumns {
  std::string name;
  std::size_t columns[3] = {};  ///< of x, y and z
};

/// A column of times.
struct TimeColumn {
  std::size_t column = 0;
  std::string name, unit;  ///< the unit in the header: "s", "ms", "us", "ns", "" if absent
};

/// The header of a text file with a row per frame and any columns.
struct PointHeader {
  std::size_t first_row = 0, cells = 0;  ///< first frame's line, from 1; number of cells in a row
  std::vector<PointColumns> points;
  std::string unit;  ///< of lengths, "" if absent
  std::optional<TimeColumn> time;
  std::optional<std::size_t> frame;          ///< column of the frame number
  std::vector<std::string> ignored_columns;  ///< names of other columns
  std::size_t lines_before = 0;              ///< number of lines before the header
  std::vector<std::string> notes;            ///< on repeated labels
};

/// Reads the header of a table (table_text.hpp), which has one line, or several above each other
/// ("wrist" over "X" "Y" "Z" over "mm"), in which a name also applies to up to two empty cells
/// after it. A column's label is the point's name and an axis, in either order, with or without
/// punctuation in between (wrist_x, wrist.X, wrist X, X:wrist, wristX); a unit may follow, or be in
/// brackets. Columns x, y, z, w of one name (a rotation) and names of rotations, velocities, forces
/// and the like are left out. A file without a header has no points. Repeated labels are numbered.
/// Throws InputError for inconsistent units.
PointHeader read_point_header(const files::CsvText& text);

}  // namespace morphe::imports
