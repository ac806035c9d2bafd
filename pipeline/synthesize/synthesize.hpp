#pragma once

#include <cstddef>
#include <cstdint>

#include "core/motion/demonstration.hpp"
#include "pipeline/synthesize/synthesize_options.hpp"

namespace morphe::synthesize {

/// A synthetic recording and its ground truth. Both have the same name, labels and object (if there
/// is one), and list in `import_notes` the values that were drawn: the kind of every movement and
/// the clock offset of the glove.
struct SyntheticRecording {
  /// The recording: sensors shoulder, elbow (on the upper arm), wrist (on the hand) and the glove,
  /// with noise; the calibration pose and the sensor offsets derived from it; the true labels.
  Demonstration recorded;
  /// The same movement without sensors, at the instants of the sensors: stream `sensors` contains
  /// the joint centres shoulder, elbow, wrist (the orientation of the wrist is that of the hand
  /// frame, the other two are the identity), `hand` the fingertips, `arm_angles` kArmAngleNames,
  /// kHandAngleNames and palm_arch; also the lengths of the arm and the object without noise.
  Demonstration truth;
};

/// Generates recording `index` of the unlimited series defined by options and seed; the result
/// depends on the arguments only.
SyntheticRecording synthesize(const SynthesizeOptions& options, std::uint64_t seed,
                              std::size_t index);

}  // namespace morphe::synthesize
