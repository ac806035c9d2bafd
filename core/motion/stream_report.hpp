#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/export.hpp"

namespace morphe {

/// Statistics of one recorded stream. A gap is a run of samples, also at an end of the stream, in
/// which one of its columns (a marker, a body, a joint) was not observed.
struct StreamReport {
  std::string name;
  double begin_s = 0, duration_s = 0, rate_hz = 0;
  double valid_share = 0;  ///< share of all values that were observed
  std::size_t columns = 0, gaps = 0;
  double longest_gap_s = 0;
  std::string longest_gap_column;          ///< the column, "" if there is no gap
  std::vector<std::string> empty_columns;  ///< columns that were never observed
};
/// Returns the statistics of all streams of a demonstration or of its calibration.
MORPHE_EXPORT std::vector<StreamReport> report_streams(const Streams& streams);

/// Returns the duration of the longest stream [s].
MORPHE_EXPORT double longest_duration_s(const std::vector<StreamReport>& streams);

}  // namespace morphe
