#pragma once

#include <vector>

#include "stages/segment/movement_unit.hpp"

namespace morphe::segment {

/// The second visit of the place of a grasp, at which the hand leaves what it took.
struct ComeBack {
  int unit = -1;          ///< index of the unit that ends at the place; -1 if there is none
  double score = 0;       ///< revisit_score() of the best unit, at least -1
  double away_ratio = 0;  ///< how far the hand goes away in between, over the reach's displacement
};

/// Searches for the second visit of the place at which `reach` ends: the end of one of the units
/// from `next` on, except the last, with the highest revisit_score(). The reach, and the way that
/// the hand goes away from the place, have to be at least `min_reach_distance`.
ComeBack find_come_back(const HandSignals& signals, const SegmentOptions& options,
                        const MovementUnit& reach, const std::vector<MovementUnit>& units,
                        int next);

/// Returns the times at which the hand turns at a place that it visits twice without stopping: it
/// takes a thing in passing, and leaves it there again. Such a turn is the slowest frame within
/// 0.1 s, slower than 0.9 of the peaks within 0.5 s on both sides, before and after which the hand
/// goes in directions that differ by more than 60 degrees (a correction on the way goes on ahead).
/// Two turns belong together if their revisit_score() is above 0.5, and if the hand is not back in
/// between at the place from which it came; this is the farthest one within 1.5 s before the first
/// turn, and that to which it goes within 1.5 s after the second.
std::vector<double> find_passing_turns(const HandSignals& signals, const SegmentOptions& options);

}  // namespace morphe::segment
