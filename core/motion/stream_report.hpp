#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/export.hpp"

namespace morphe {

/// One recorded stream. A gap is a run of samples in which one of its columns (a marker, a body, a
/// joint) was not seen, at the ends too.
struct StreamReport {
  std::string name;
  double begin_s = 0, duration_s = 0, rate_hz = 0;
  double seen = 0;  ///< share of its values that are there
  std::size_t columns = 0, gaps = 0;
  double longest_gap_s = 0;
  std::string longest_gap_of;       ///< the column, "" without a gap
  std::vector<std::string> unseen;  ///< columns that were never seen
};
/// All streams of a demonstration, or of its calibration.
MORPHE_EXPORT std::vector<StreamReport> report_streams(const Streams& streams);

/// The longest of its streams [s].
MORPHE_EXPORT double longest_s(const std::vector<StreamReport>& streams);

}  // namespace morphe
