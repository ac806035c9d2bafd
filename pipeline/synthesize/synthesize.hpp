#pragma once

#include <cstddef>
#include <cstdint>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// A recording that never was, and what it should have shown. Both have the same name, labels and
/// (if there is one) object, and say in `reports` what was drawn: the kind of every movement, the
/// glove's clock offset.
struct SyntheticRecording {
  /// Sensors shoulder, elbow (on the upper arm), wrist (on the hand) and the glove, with noise; the
  /// calibration pose and the sensor offsets that follow from it; the true labels.
  Demonstration recorded;
  /// The same movement without sensors, at the sensors' instants: stream `sensors` holds the joint
  /// centres shoulder, elbow, wrist (the wrist's orientation is the hand frame's, the other two are
  /// the identity), `hand` the fingertips, `arm_angles` kArmAngleNames, kHandAngleNames and
  /// palm_arch; also the arm's lengths and the object without noise.
  Demonstration truth;
};

/// Recording `index` of the endless series that options and seed define; depends on nothing else.
SyntheticRecording synthesize(const SynthesizeOptions& options, std::uint64_t seed,
                              std::size_t index);

}  // namespace morphe::synthesize
