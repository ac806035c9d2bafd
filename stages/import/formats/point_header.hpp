#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/csv.hpp"

namespace morphe::imports {

/// Columns of a table of points.
struct PointColumns {
  std::string name;
  std::size_t at[3] = {};  ///< of x, y and z
};

/// A column of time, and what its header says of the unit.
struct TimeColumn {
  std::size_t at = 0;
  std::string name, unit;  ///< "s", "ms", "us", "ns", "" = not said
};

/// The header of a text file with a row a frame, whatever its columns.
struct PointHeader {
  char separator = ',';
  bool decimal_comma = false;
  std::size_t first_row = 0, cells = 0;  ///< line of the first frame; cells of a row
  std::vector<PointColumns> points;
  std::string unit;  ///< of lengths, "" = not said
  std::optional<TimeColumn> time;
  std::optional<std::size_t> frame;
  std::vector<std::string> left_out;  ///< columns that are neither
  std::size_t before = 0;             ///< lines before the header
};

/// Cells of a line, quotes ("a;b", "" for one) taken off.
std::vector<std::string> quoted_cells(std::string_view line, char separator);

/// A cell's number as the file writes it; nothing for text, and for the other of comma and point.
std::optional<double> number_in(std::string_view cell, bool decimal_comma);

/// Whether a cell says that there is no number: empty, NaN, NA, null, none, -.
bool says_nothing(std::string_view cell);

/// Reads the header: one line or several above each other ("wrist" over "X" "Y" "Z" over "mm"; a
/// name counts for the empty cells behind it). The columns of a point are its name and an axis, in
/// either order, with any sign or none between (wrist_x, wrist.X, wrist X, X:wrist, wristX); a unit
/// may follow, or stand in brackets. Three columns that have a fourth, w, are a rotation, and those
/// whose name speaks of one, of a velocity, a force or the like are no points: both are left out.
/// No points: there is none. InputError for units that differ, and a point that stands twice.
PointHeader read_point_header(const files::CsvText& text);

}  // namespace morphe::imports
