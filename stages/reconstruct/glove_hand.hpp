#pragma once

#include "core/human/hand.hpp"
#include "core/motion/demonstration.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// The filtered sensor signals of a glove on a clock (glove_filter.hpp), one column per sensor in
/// the order of kGloveSensors.
using GloveColumns = std::vector<std::vector<double>>;
/// Resamples and filters a glove's sensors. The mean of the calibration's flat hand is zero;
/// without a calibration the glove's own zero is kept, and `problems` gets a sentence. Its times
/// are shifted by -`late_s`.
GloveColumns resample_glove(const HandStream& glove, const std::optional<HandStream>& flat_hand,
                            double late_s, const TimeGrid& clock, const ReconstructOptions& options,
                            std::vector<std::string>& problems);

/// Computes hand angles, and with the wrist's pose also tips, tip orientations and middle joints.
/// Sensors that a glove lacks are replaced and named in `estimated`: a finger's last joint bends
/// 2/3 as much as its middle one, and the palm's arch is flat. A finger that lacks another sensor
/// stays unseen.
void pose_fingers(const GloveColumns& glove, const human::HandSize& size, HumanMotion& motion);

/// Returns length and breadth of the hand: the recorded ones, otherwise those for the stature
/// (noted in `estimated`).
human::HandSize hand_size_of(const Demonstration& demonstration, const HumanOptions& human,
                             std::vector<std::string>& estimated);

}  // namespace morphe::reconstruct
