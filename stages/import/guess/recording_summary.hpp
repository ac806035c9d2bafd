#pragma once

#include <map>
#include <string>
#include <vector>

#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// The summary of a point of a recording.
struct PointSummary {
  std::string name;
  double seen_share = 0;  ///< share of the frames in which it was seen
  Vec3 extent, centre;    ///< of its bounding box, in the unit of the points; NaN if never seen
  std::string body_part;  ///< or ""
};

/// The contents of a recording, for inspection by the user.
struct RecordingSummary {
  std::string file;
  std::vector<PointSummary> points;
  std::string unit;                    ///< unit of extent and centre: "m", or "" for the file's own
  std::size_t rows = 0;                ///< number of frames
  double rate_hz = 0, duration_s = 0;  ///< from its times; 0 if unknown
};

/// Summarises the points; file and unit stay empty. `renamed` maps recorded names to Morphe's.
RecordingSummary summarise_points(const RecordedPoints& points,
                                  const std::map<std::string, std::string>& renamed = {});

/// Returns a table with a line for each point or, of more than 40 points, for each one with a body
/// part, and the names of up to 40 others; "" without points.
std::string summary_text(const RecordingSummary& summary);

}  // namespace morphe::imports
