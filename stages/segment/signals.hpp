#pragma once

#include <vector>

#include "pipeline/motion/human_motion.hpp"

namespace morphe {

/// What segmentation looks at, on the clock of the recording.
struct HandSignals {
  double begin_s = 0, step_s = 0;
  std::vector<double> speed;    ///< [N] [m/s], gaps bridged linearly
  std::vector<Vec3> position;   ///< [N] index tip, or wrist if the tip is seen in less than half
  std::vector<double> opening;  ///< [N] thumb tip to index tip [m], gaps bridged; empty if unseen
  std::vector<bool> seen;       ///< [N] tip or wrist was seen

  std::size_t frames() const { return speed.size(); }
  double time(double frame) const { return begin_s + frame * step_s; }
  std::size_t frame(double time_s) const;  ///< nearest
};

/// Empty if there are fewer than 10 frames, the clock does not advance or nothing was seen.
HandSignals hand_signals(const HumanMotion& motion, double smoothing_s);

}  // namespace morphe
