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
  /// Extent and centre of its bounding box, in the unit of the points; NaN if it was never seen.
  Vec3 extent, centre;
  std::string body_part;  ///< part of the body, or ""
};

/// The contents of a recording, for inspection by the user.
struct RecordingSummary {
  std::string file;                    ///< name of the file
  std::vector<PointSummary> points;    ///< summaries of all points
  std::string unit;                    ///< unit of extent and centre: "m", or "" for the file's own
  std::size_t rows = 0;                ///< number of frames
  double rate_hz = 0, duration_s = 0;  ///< from its times; 0 if unknown
};

/// Summarises the points. `renamed` maps their names to Morphe's, which determine their body parts.
RecordingSummary summarise_points(const RecordedPoints& points,
                                  const std::map<std::string, std::string>& renamed = {});

/// Returns a line for each point with a body part, or for all if there are few; the others are
/// listed by name.
std::string summary_text(const RecordingSummary& survey);

}  // namespace morphe::imports
