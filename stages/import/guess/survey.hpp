#pragma once

#include <map>
#include <string>
#include <vector>

#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// One point of a recording.
struct SurveyedPoint {
  std::string name;
  double seen = 0;        ///< share of frames
  Vec3 extent, middle;    ///< of the box that holds it, in the unit of the points; NaN = never seen
  std::string taken_for;  ///< part of the body, "" = nothing
};

/// What a recording shows, to be looked at before it is trusted.
struct Survey {
  std::string file;
  std::vector<SurveyedPoint> points;
  std::string unit;  ///< of middle and extent: "m", or "" for the file's own
  std::size_t rows = 0;
  double rate_hz = 0, duration_s = 0;  ///< by its times; 0 = not known
};

/// `renamed` maps names of the points to Morphe's, for what they are taken for.
Survey survey_of(const RecordedPoints& points,
                 const std::map<std::string, std::string>& renamed = {});

/// A line a point that is taken for something, or for all if few are; the others by name.
std::string survey_text(const Survey& survey);

}  // namespace morphe::imports
