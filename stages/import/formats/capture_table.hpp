#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "stages/import/formats/capture_columns.hpp"

namespace morphe::imports {

/// The numbers in all cells of a capture table, NaN if not seen.
struct CaptureTable {
  std::vector<double> time;    ///< [N] [s]
  std::size_t columns = 0;     ///< number of columns
  std::vector<double> values;  ///< [N, columns]

  /// Returns the cells of a row.
  std::span<const double> operator[](std::size_t row) const {
    return {values.data() + row * columns, columns};
  }
};

/// Reads the rows from line 2 on; time is time_s, otherwise the frames since the first over
/// rate_hz. Throws InputError for a row with another number of cells, a cell that is not a number,
/// and time that is missing, does not advance or jumps by more than an hour.
CaptureTable read_capture_table(const files::CsvText& csv, const CaptureColumns& columns,
                                double rate_hz);

}  // namespace morphe::imports
