#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/motion/demonstration.hpp"
#include "stages/synthesize/synthesize_options.hpp"

namespace morphe {

/// A recording that never was, and what it should have shown.
struct SyntheticRecording {
  /// Sensors shoulder, elbow, wrist with noise, the glove, their calibration pose, the objects and
  /// the true labels.
  Demonstration recorded;
  /// The same movement without sensors: stream `sensors` holds the joint centres shoulder, elbow,
  /// wrist (the wrist's orientation is the hand frame's, the other two are the identity), `hand`
  /// the fingertips, `arm_angles` kArmAngleNames and kHandAngleNames, all on the arm's clock.
  Demonstration truth;
};

/// Recording `index` of the endless series that options and seed define; depends on nothing else.
SyntheticRecording synthesize(const SynthesizeOptions& options, std::uint64_t seed,
                              std::size_t index);

}  // namespace morphe
