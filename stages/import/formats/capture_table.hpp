#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "stages/import/formats/capture_columns.hpp"

namespace morphe::imports {

/// The numbers of a capture table, NaN in empty cells and left-out columns. Row i is line i + 2.
struct CaptureTable {
  std::vector<double> time;  ///< [N] [s]
  std::size_t columns = 0;
  std::vector<double> values;  ///< [N, columns]

  /// Returns the cells of a row.
  std::span<const double> operator[](std::size_t row) const {
    return {values.data() + row * columns, columns};
  }
};

/// Reads the rows from line 2 on. The time is the column time_s; without it, it is that of the
/// column frame, less its first value, over `rate_hz`; one of the two must exist. Throws InputError
/// for a row with another number of cells than the header, a cell that is not a number, and a time
/// that is missing, does not increase, or increases by more than an hour.
CaptureTable read_capture_table(const files::CsvText& csv, const CaptureColumns& columns,
                                double rate_hz);

}  // namespace morphe::imports
