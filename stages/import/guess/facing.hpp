#pragma once

#include <optional>
#include <string>

#include "stages/import/guess/body_cues.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// Which way a person faces, as the body shows it.
struct Facing {
  double turn = 0;          ///< about Z, after which the person faces Y [rad], in (-pi, pi]
  CueOf by = CueOf::trunk;  ///< what it was seen from
  double agreement = 1;     ///< of the cues with each other; 1 = all of them say the same
  bool turns = false;       ///< the person turns round: taken from the first second
  std::string because;      ///< half a sentence
};

/// The turn that maximises sum over the cues of weight * <world, Rz(turn) recorded>, over their
/// horizontal parts, of the cues of the kind that says most, in the frames at rest (body_cues.hpp),
/// or in all where those do not say it. Where the world is turned by an angle, it changes by that
/// angle. Nothing where no cue is horizontal. Z of the points is up; `hand`: the recorded one.
std::optional<Facing> facing_of(const RecordedPoints& points, Side hand);

/// Turns all of a recording, its calibration and its objects about the vertical, so that the
/// person faces Y; not so where the axes decide, where they were given and the trunk was not
/// recorded, where nothing shows it, or what shows it contradicts itself. A hand in a frame of its
/// own (keypoints alone) has no place and is left. Says in `reports` what was done, and where the
/// body stands otherwise than axes that nobody gave.
void face_forward(const Conventions& given, Demonstration& demonstration);

}  // namespace morphe::imports
