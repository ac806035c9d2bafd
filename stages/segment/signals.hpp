#pragma once

#include <vector>

#include "core/motion/human_motion.hpp"

namespace morphe::segment {

/// Largest gap between two peaks that may form one movement unit [s].
inline constexpr double kMaxMergeGap_s = 0.1;
/// Least change of the aperture, as a multiple of the rms of its noise.
inline constexpr double kMinApertureNoiseRatio = 3;
/// Least displacement of the wrist in a reach, as a share of the tip's.
inline constexpr double kMinWristShare = 0.25;

/// The signals used for segmentation, on the clock of the recording.
struct HandSignals {
  /// Time of the first frame and time between frames [s].
  double begin_s = 0, step_s = 0;
  std::vector<Vec3> position;  ///< [N] index tip [m]; if unseen, carried along by the wrist
  std::vector<Vec3> wrist;     ///< [N] wrist [m], gaps bridged
  /// [N] speed of `position` [m/s], with the mean square of the noise subtracted.
  std::vector<double> speed;
  /// [N] distance from thumb tip to index tip [m], gaps bridged; empty if unseen.
  std::vector<double> aperture;
  std::vector<bool> seen;     ///< [N] true if tip or wrist was seen
  double speed_noise = 0;     ///< rms of the speed at rest [m/s]
  double aperture_noise = 0;  ///< rms of the noise of the aperture [m]

  /// Returns the number of frames.
  std::size_t frames() const { return speed.size(); }
  /// Returns the time of a (fractional) frame [s].
  double time(double frame) const { return begin_s + frame * step_s; }
  std::size_t frame(double time_s) const;  ///< nearest frame
  /// Returns the time of the last frame [s].
  double end_s() const { return time(static_cast<double>(frames() - 1)); }
};

/// Computes the signals of a motion. Velocities are averaged by a Gaussian of standard deviation
/// `smoothing_s`, widened by up to four times until the noise falls below 2 % of the speed at which
/// most of the distance is travelled. Frames in which neither tip nor wrist is seen are bridged by
/// a cubic that preserves position and velocity at both ends, so that displacement during a gap is
/// retained. Returns empty signals if there are fewer than 10 frames, the clock does not advance or
/// the wrist was never seen.
HandSignals hand_signals(const HumanMotion& motion, double smoothing_s);

}  // namespace morphe::segment
