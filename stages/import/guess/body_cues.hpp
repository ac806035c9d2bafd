#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/side.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// The part of the body that gives a cue, the least reliable for the heading of a person first.
enum class CueSource : std::uint8_t { reach, hand, arm, trunk };

/// The use of a cue: to identify the axes, or to determine the forward direction once up is known.
enum class CuePurpose : std::uint8_t { both, axes, heading };

/// A recorded direction and its usual value in the person's frame (X right, Y forward, Z up).
struct BodyCue {
  Vec3 recorded, world;  ///< unit vectors
  double weight = 1;     ///< relative to the other cues
  CueSource source = CueSource::arm;
  const char* description = "";  ///< half a sentence
  bool undirected = false;       ///< true if `recorded` or its opposite may be meant
  CuePurpose purpose = CuePurpose::both;
};

/// Returns all cues in the points, by their source:
///   trunk  from left to right shoulder and hip; ankles, hips, shoulders and head above each other;
///          chest in front of back and shoulders; toes in front of ankles
///   arm    elbow below the shoulder, and outside of the line from shoulder to hand; hand in front
///          of the shoulder; the hand travels least along the vertical, as above a table
///   hand   fingers point away from the person, a little inwards; from the left to the right hand
///   reach  the hand starts to move forward
std::vector<BodyCue> body_cues(const RecordedPoints& points);

/// Returns the frames in which the wrist of `hand` is at most a quarter of its largest distance
/// away from its first seen position; all frames if it was never seen. In other frames the trunk
/// does not show the person's heading: a reach turns it and draws the shoulder forward.
RecordedPoints frames_at_rest(const RecordedPoints& points, Side hand);

}  // namespace morphe::imports
