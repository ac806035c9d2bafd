#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::study {

/// Root mean square of what was added.
struct MeanSquare {
  double sum = 0;
  std::size_t n = 0;
  void add(double error) {
    if (!std::isfinite(error)) return;
    sum += error * error;
    ++n;
  }
  void add(const MeanSquare& other) {
    sum += other.sum;
    n += other.n;
  }
  double rms() const { return n == 0 ? kNotSeen : std::sqrt(sum / static_cast<double>(n)); }
};

/// A rebuilt recording against the truth it was synthesized from.
struct ReconstructionScore {
  MeanSquare shoulder, elbow, wrist, tips;  ///< distance from the truth [m]
  MeanSquare tips_in_hand;             ///< the same in the hand's own frame: the glove's part [m]
  MeanSquare orientation;              ///< of the hand, full angle [rad]
  MeanSquare arm_angles, hand_angles;  ///< [rad]
  MeanSquare speed_at_rest, true_at_rest;  ///< of the index tip where it truly rests [m/s]
  std::vector<double> delay_s;             ///< of the index tip behind the truth, one a recording
  std::vector<double> peak_ratio;          ///< rebuilt over true peak speed, one a labelled reach
  std::size_t seen = 0, frames = 0;        ///< frames with wrist and tips

  void add(const ReconstructionScore& other);
};

/// `truth` as pipeline/synthesize/synthesize.hpp describes it: joint centres in `sensors`,
/// fingertips in `hand`, angles in `arm_angles`, all on one clock.
ReconstructionScore score_reconstruction(const HumanMotion& motion, const Demonstration& truth);

/// Delay of `signal` behind `reference` [s], both sampled every `step_s`: the peak of the
/// cross-correlation of what is left after their means, within ±0.2 s, to a parabola through its
/// top three points. NaN where either does not vary.
double delay_behind(const std::vector<double>& signal, const std::vector<double>& reference,
                    double step_s);

}  // namespace morphe::study
