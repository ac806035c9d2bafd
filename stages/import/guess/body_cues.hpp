#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/side.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// Of what a cue is, from what says least of how a person stands to what says most.
enum class CueOf : std::uint8_t { way, hand, arm, trunk };

/// What a cue is good for: which axes are which, or which way is forward once up is known.
enum class CueFor : std::uint8_t { both, axes, heading };

/// A recorded direction that points along one of the world's (X right, Y forward, Z up of the
/// person), on average over a recording.
struct BodyCue {
  Vec3 recorded, world;  ///< unit
  double weight = 1;     ///< of those of the same kind
  CueOf of = CueOf::arm;
  const char* what = "";  ///< half a sentence
  bool signless = false;  ///< a line, not an arrow
  CueFor use = CueFor::both;
};

/// All that the points show:
///   trunk  from left to right shoulder and hip; hips, shoulders and head above each other; the
///          chest before back and shoulders; toes before ankles
///   arm    the elbow below the shoulder and outside of the line from it to the hand; the hand
///          before the shoulder, along a table
///   hand   fingers point away from the person, a little inwards; from the left to the right hand
///   way    a hand leaves for what is in front
std::vector<BodyCue> body_cues(const RecordedPoints& points);

/// The frames in which the hand is where it was first seen: no farther from there than a quarter of
/// the way that it ever goes. The trunk then stands as the person sits or stands, while a reach
/// turns it and draws the shoulder forward. All frames where no wrist was seen.
RecordedPoints points_at_rest(const RecordedPoints& points, Side hand);

}  // namespace morphe::imports
