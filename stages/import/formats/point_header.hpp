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
  std::size_t at[3] = {};  ///< columns of x, y and z
};

/// A column of time, with the unit given in the header.
struct TimeColumn {
  std::size_t at = 0;      ///< index of the column
  std::string name, unit;  ///< "s", "ms", "us", "ns", "" if absent
};

/// The header of a text file with a row per frame and any columns.
struct PointHeader {
  char separator = ',';                      ///< comma, semicolon or tab
  bool decimal_comma = false;                ///< true if numbers have a decimal comma
  std::size_t first_row = 0, cells = 0;      ///< line of the first frame; number of cells in a row
  std::vector<PointColumns> points;          ///< columns of the points
  std::string unit;                          ///< unit of lengths, "" if absent
  std::optional<TimeColumn> time;            ///< column of the time, if any
  std::optional<std::size_t> frame;          ///< column of the frame number, if any
  std::vector<std::string> ignored_columns;  ///< columns that are neither points nor time nor frame
  std::size_t lines_before = 0;              ///< number of lines before the header
};

/// Returns the cells of a line without their quotes ("a;b", "" for one quote).
std::vector<std::string> quoted_cells(std::string_view line, char separator);

/// Returns a cell's number in the file's notation; no value for text, and for the other one of
/// comma and point.
std::optional<double> parse_number(std::string_view cell, bool decimal_comma);

/// Returns true if a cell denotes a missing number: empty, NaN, NA, null, none, -.
bool is_missing_value(std::string_view cell);

/// Reads the header: one line or several above each other ("wrist" over "X" "Y" "Z" over "mm"; a
/// name also applies to the empty cells after it). The columns of a point are labelled by its name
/// and an axis, in either order, with or without punctuation in between (wrist_x, wrist.X, wrist X,
/// X:wrist, wristX); a unit may follow, or be in brackets. Three columns with a fourth, w, are a
/// rotation, and names may denote a rotation, a velocity, a force or the like: both are left out.
/// Without any points there is no header. Throws InputError for inconsistent units, and a repeated
/// point.
PointHeader read_point_header(const files::CsvText& text);

}  // namespace morphe::imports
