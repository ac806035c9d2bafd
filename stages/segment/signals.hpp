#pragma once

#include <vector>

#include "core/motion/human_motion.hpp"

namespace morphe::segment {

/// Two peaks this near to each other may be one movement [s].
inline constexpr double kFollows_s = 0.1;
/// Rms of its noise by which the opening must change to be believed.
inline constexpr double kOpeningAboveNoise = 3;
/// Share of a tip's way that the wrist must go for the way to be a reach.
inline constexpr double kWithWrist = 0.25;

/// What segmentation looks at, on the clock of the recording.
struct HandSignals {
  double begin_s = 0, step_s = 0;
  std::vector<Vec3> position;   ///< [N] index tip [m]; where it was not seen, carried by the wrist
  std::vector<Vec3> wrist;      ///< [N] [m], gaps bridged
  std::vector<double> speed;    ///< [N] of `position` [m/s], its noise taken off in the mean square
  std::vector<double> opening;  ///< [N] thumb tip to index tip [m], gaps bridged; empty if unseen
  std::vector<bool> seen;       ///< [N] tip or wrist was seen
  double speed_noise = 0;       ///< rms of speed where nothing happens [m/s]
  double opening_noise = 0;     ///< likewise of the opening [m]

  std::size_t frames() const { return speed.size(); }
  double time(double frame) const { return begin_s + frame * step_s; }
  std::size_t frame(double time_s) const;  ///< nearest
  double end_s() const { return time(static_cast<double>(frames() - 1)); }
};

/// Velocities are averaged by a Gaussian of standard deviation `smoothing_s`, or as many times
/// wider (up to four) as it takes for the noise to fall below 2 % of the speed at which most of the
/// way is travelled. Frames in which neither tip nor wrist is seen are bridged by a cubic that
/// keeps place and velocity at both ends, so that a way travelled unseen is still travelled. Empty
/// if there are fewer than 10 frames, the clock does not advance or the wrist was never seen.
HandSignals hand_signals(const HumanMotion& motion, double smoothing_s);

}  // namespace morphe::segment
