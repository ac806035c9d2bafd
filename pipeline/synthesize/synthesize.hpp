#pragma once

#include <cstddef>
#include <cstdint>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// A synthetic recording and its ground truth, with the same name, subject and labels. Both list
/// the kind of every movement and the clock offset of the glove in `import_notes`.
struct SyntheticRecording {
  /// Sensors, glove and a tracked object, with noise; the static recording, and the sensor offsets
  /// derived from it.
  Demonstration recorded;
  /// The true motion at the instants of the sensors, the lengths of the arm, and the object without
  /// noise. `sensors` contains the joint centres shoulder, elbow and wrist; the orientation of the
  /// wrist is that of the hand's frame, the others are the identity. `hand` contains the
  /// fingertips, `arm_angles` the angles kArmAngleNames, kHandAngleNames and palm_arch.
  Demonstration truth;
};

/// Generates recording `k` of a series, which depends on the arguments only.
SyntheticRecording synthesize(const SynthesizeOptions& options, std::uint64_t seed, std::size_t k);

}  // namespace morphe::synthesize
