#pragma once

#include "core/human/hand.hpp"
#include "core/motion/demonstration.hpp"
#include "stages/reconstruct/time_grid.hpp"

namespace morphe::reconstruct {

/// The filtered signals of a glove on a clock (glove_filter.hpp), a column for each kGloveSensors.
using GloveColumns = std::vector<std::vector<double>>;
/// Resamples and filters a glove's sensors; `late_s` is subtracted from their times. The mean of
/// `flat_hand` becomes zero; without it the glove keeps its zero and `problems` gets a sentence.
GloveColumns resample_glove(const HandStream& glove, const std::optional<HandStream>& flat_hand,
                            double late_s, const TimeGrid& clock, const ReconstructOptions& options,
                            std::vector<std::string>& problems);

/// Computes the hand angles of `motion`, and in frames with the wrist's pose tips, tip orientations
/// and middle joints. Two kinds of missing sensors are replaced and named in `estimated`: a
/// finger's last joint bends 2/3 as much as its middle one, and the palm's arch is flat. A finger
/// that lacks another sensor stays unseen.
void pose_fingers(const GloveColumns& glove, const human::HandSize& size, HumanMotion& motion);

/// Returns the recorded size of the hand. A length that was not recorded is that for the stature,
/// such a breadth is in proportion to the length; both are named in `estimated`.
human::HandSize hand_size_of(const Demonstration& demonstration, const HumanOptions& human,
                             std::vector<std::string>& estimated);

}  // namespace morphe::reconstruct
