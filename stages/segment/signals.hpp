#pragma once

#include <vector>

#include "core/motion/human_motion.hpp"

namespace morphe::segment {

/// The signals used for segmentation, on the clock of the recording.
struct HandSignals {
  double begin_s = 0, step_s = 0;  ///< time of the first frame and time between frames
  std::vector<Vec3> position;      ///< [N] index tip [m], estimated while unseen
  std::vector<Vec3> wrist;         ///< [N] wrist [m], gaps bridged
  std::vector<double> speed;     ///< [N] of `position` [m/s]: sqrt(max(0, |v|² − speed_noise²))
  std::vector<double> aperture;  ///< [N] thumb tip to index tip [m], gaps bridged; empty if unseen
  std::vector<bool> seen;        ///< [N] true if tip or wrist was seen
  double speed_noise = 0;        ///< rms of the speed at rest [m/s]
  double aperture_noise = 0;     ///< rms of the noise of the aperture [m]

  int frames() const { return static_cast<int>(speed.size()); }
  /// Returns the time of a frame, which may be fractional [s].
  double time(double frame) const { return begin_s + frame * step_s; }
  double end_s() const { return time(frames() - 1); }  ///< of the last frame
  int frame(double time_s) const;                      ///< nearest frame
  /// Returns the number of whole frames in a duration, at most twice the number of frames.
  int frames_in(double duration_s) const;
};

/// Computes the signals of a motion. Velocities are averaged by a Gaussian of standard deviation
/// `smoothing_s` (0: not at all), widened up to fourfold until the noise falls below 2 % of the
/// speed Σ v² / Σ v, which rests do not change. A gap, in which neither tip nor wrist is seen, is
/// bridged by a cubic that preserves position and velocity at both ends, so that the displacement
/// during it is retained; a gap of the aperture is bridged linearly. Returns empty signals if there
/// are fewer than 10 frames, the clock does not advance or the wrist was never seen.
HandSignals hand_signals(const HumanMotion& motion, double smoothing_s);

}  // namespace morphe::segment
