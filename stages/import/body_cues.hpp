#pragma once

#include <cstdint>
#include <vector>

#include "stages/import/recorded_points.hpp"

namespace morphe::imports {

/// Of what a cue is, from what says least of how a person stands to what says most.
enum class CueOf : std::uint8_t { hand, arm, trunk };

/// A recorded direction that points along one of the world's (X right, Y forward, Z up of the
/// person), on average over a recording.
struct BodyCue {
  Vec3 recorded, world;  ///< unit
  double weight = 1;     ///< of those of the same kind
  CueOf of = CueOf::arm;
  const char* what = "";  ///< half a sentence
  bool signless = false;  ///< a line, not an arrow
};

/// All that the points show:
///   trunk  from left to right shoulder and hip; hips, shoulders and head above each other; the
///          chest before back and shoulders; toes before ankles
///   arm    the elbow below the shoulder and outside of the line from it to the hand; the hand
///          before the shoulder, along a table
///   hand   fingers point away from the person; a hand reaches forward
std::vector<BodyCue> body_cues(const RecordedPoints& points);

}  // namespace morphe::imports
