#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/side.hpp"
#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// The part of the body from which a cue is taken, in increasing order of reliability for the
/// heading of a person.
enum class CueSource : std::uint8_t { reach, hand, arm, trunk };

/// The use of a cue: to identify the axes, or to determine the forward direction once up is known.
enum class CuePurpose : std::uint8_t { both, axes, heading };

/// A recorded direction that points along one of the world's (X right, Y forward, Z up of the
/// person), on average over a recording.
struct BodyCue {
  Vec3 recorded, world;                   ///< unit vectors
  double weight = 1;                      ///< weight among cues of the same kind
  CueSource source = CueSource::arm;      ///< part of the body
  const char* description = "";           ///< half a sentence
  bool undirected = false;                ///< true for a line without direction
  CuePurpose purpose = CuePurpose::both;  ///< use of the cue
};

/// Returns all cues in the points:
///   trunk  from left to right shoulder and hip; hips, shoulders and head above each other; the
///          chest before back and shoulders; toes before ankles
///   arm    the elbow below the shoulder and outside of the line from it to the hand; the hand
///          before the shoulder, along a table
///   hand   fingers point away from the person, a little inwards; from the left to the right hand
///   reach  a hand departs towards an object in front
std::vector<BodyCue> body_cues(const RecordedPoints& points);

/// Returns the frames in which the hand is at its initial position: at a distance of at most a
/// quarter of its largest distance from there. The trunk then has the heading of the sitting or
/// standing person, while a reach turns it and draws the shoulder forward. Returns all frames if no
/// wrist was seen.
RecordedPoints frames_at_rest(const RecordedPoints& points, Side hand);

}  // namespace morphe::imports
