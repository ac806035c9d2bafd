#pragma once

#include "core/human/hand.hpp"
#include "core/motion/demonstration.hpp"
#include "stages/reconstruct/clock.hpp"

namespace morphe::reconstruct {

/// A glove's sensors on a clock, filtered (glove_filter.hpp): kGloveSensors by column. The
/// calibration's flat hand (means over its frames) is zero; without one the glove's own zero stays,
/// and `problems` says so. Its times are moved by -`late_s`.
using GloveColumns = std::vector<std::vector<double>>;
GloveColumns glove_on_clock(const HandStream& glove, const std::optional<HandStream>& flat_hand,
                            double late_s, const Clock& clock, const ReconstructOptions& options,
                            std::vector<std::string>& problems);

/// Hand angles, and with the wrist's pose tips, tip orientations and middle joints. Sensors that a
/// glove lacks are made up for, and named in `estimated`: a finger's last joint bends 2/3 as much
/// as its middle one, the palm's arch is flat. A finger lacking another sensor stays unseen.
void pose_fingers(const GloveColumns& glove, const human::HandSize& size, HumanMotion& motion);

/// Length and breadth of the hand: recorded ones first, else by the stature (in `estimated`).
human::HandSize hand_size_of(const Demonstration& demonstration, const HumanOptions& human,
                             std::vector<std::string>& estimated);

}  // namespace morphe::reconstruct
