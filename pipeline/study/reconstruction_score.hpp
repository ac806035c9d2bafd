#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::study {

/// An accumulator for the root mean square of errors.
struct MeanSquare {
  /// The sum of the squared errors.
  double sum = 0;
  /// The number of errors.
  std::size_t n = 0;
  /// Adds an error unless it is not finite.
  void add(double error) {
    if (!std::isfinite(error)) return;
    sum += error * error;
    ++n;
  }
  /// Adds all errors of `other`.
  void add(const MeanSquare& other) {
    sum += other.sum;
    n += other.n;
  }
  /// Returns the root mean square, NaN if there are no errors.
  double rms() const { return n == 0 ? kUnknown : std::sqrt(sum / static_cast<double>(n)); }
};

/// The errors of a reconstructed recording with respect to the ground truth from which it was
/// synthesized.
struct ReconstructionScore {
  /// Distance from the ground truth [m].
  MeanSquare shoulder, elbow, wrist, tips;
  /// The same in the frame of the hand, that is, the error of the glove [m].
  MeanSquare tips_in_hand;
  /// Full angle of the orientation error of the hand [rad].
  MeanSquare orientation;
  /// Errors of the joint angles [rad].
  MeanSquare arm_angles, hand_angles;
  /// Speed of the index tip, reconstructed and true, while the true tip rests [m/s].
  MeanSquare speed_at_rest, true_speed_at_rest;
  /// Delay of the index tip behind the ground truth, one for each recording [s].
  std::vector<double> delay_s;
  /// Reconstructed divided by true peak speed, one for each labelled reach.
  std::vector<double> peak_ratio;
  /// Number of frames with wrist and tips, and of all frames.
  std::size_t seen = 0, frames = 0;

  /// Adds the errors of another recording.
  void add(const ReconstructionScore& other);
};

/// Computes the errors of a reconstruction. `truth` has the form that
/// pipeline/synthesize/synthesize.hpp describes: joint centres in `sensors`, fingertips in `hand`,
/// angles in `arm_angles`, all on one clock.
ReconstructionScore score_reconstruction(const HumanMotion& motion, const Demonstration& truth);

/// Estimates the delay of `signal` behind `reference` [s], both sampled every `step_s`: the peak of
/// the cross-correlation of the signals without their means, within ±0.2 s, refined by a parabola
/// through its top three points. Returns NaN if one of the signals is constant.
double estimate_delay_s(const std::vector<double>& signal, const std::vector<double>& reference,
                        double step_s);

}  // namespace morphe::study
