#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "stages/import/formats/capture_columns.hpp"

namespace morphe::imports {

/// Every cell of a capture's table as a number, NaN = not seen.
struct CaptureTable {
  std::vector<double> time;  ///< [N] [s]
  std::size_t columns = 0;
  std::vector<double> values;  ///< [N, columns]

  std::span<const double> operator[](std::size_t row) const {
    return {values.data() + row * columns, columns};
  }
};

/// Rows from line 2 on; time is time_s, else the frames since the first over rate_hz. InputError
/// for a row with another number of cells, a cell that is no number, and time that is missing, does
/// not advance or jumps by more than an hour.
CaptureTable read_capture_table(const files::CsvText& csv, const CaptureColumns& columns,
                                double rate_hz);

}  // namespace morphe::imports
