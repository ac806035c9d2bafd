#pragma once

#include <cmath>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::study {

/// An accumulator for the root mean square of errors.
struct MeanSquare {
  double sum = 0;  ///< of the squared errors
  int n = 0;       ///< number of errors

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
  double rms() const { return n == 0 ? kUnknown : std::sqrt(sum / n); }
};

/// The errors of a reconstruction with respect to the ground truth of a synthetic recording.
struct ReconstructionScore {
  MeanSquare shoulder, elbow, wrist, tips;  ///< distance from the ground truth [m]
  MeanSquare tips_in_hand;  ///< same in the frame of the hand, due to the finger angles alone [m]
  MeanSquare orientation;   ///< full angle of the orientation error of the hand [rad]
  MeanSquare arm_angles, hand_angles;            ///< errors of the joint angles [rad]
  MeanSquare speed_at_rest, true_speed_at_rest;  ///< of the index tip, true speed <= 5 mm/s [m/s]
  std::vector<double> delay_s;     ///< of the index tip behind the ground truth, one per recording
  std::vector<double> peak_ratio;  ///< reconstructed over true peak speed, one per labelled reach
  int seen = 0, frames = 0;        ///< number of frames with wrist and tips, and of all frames

  /// Adds the errors of another recording.
  void add(const ReconstructionScore& other);
};

/// Computes the errors of a reconstruction. `truth` has the form that
/// pipeline/synthesize/synthesize.hpp describes: joint centres in `sensors`, fingertips in `hand`,
/// angles in `arm_angles`, all on one clock.
ReconstructionScore score_reconstruction(const HumanMotion& motion, const Demonstration& truth);

/// Returns the delay of `signal` behind `reference` [s], both of the same length, with a value
/// every `step_s`. It is the peak of the cross-correlation of the signals without their means,
/// within ±0.2 s (at most a quarter of the length), refined by a parabola through the top three
/// points. Returns NaN if there is no peak inside this range, as for a constant signal.
double estimate_delay_s(const std::vector<double>& signal, const std::vector<double>& reference,
                        double step_s);

}  // namespace morphe::study
