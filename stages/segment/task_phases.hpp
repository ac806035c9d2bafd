#pragma once

#include "stages/segment/interaction.hpp"

namespace morphe::segment {

/// Adds a phase, unless it is shorter than half a frame. Its confidence is the mean of those of its
/// boundaries times the share of its frames in which the hand was seen.
void add_phase(const HandSignals& signals, const Phase& phase, Movement& movement);

/// Adds the phases that refine transport and return to a movement with all its main phases; none
/// without a transport. h is the height of the lowest point of the target, if its motion by this
/// hand was recorded, otherwise that of the index tip, which carries it:
///
///   lift      from the begin of the first transport until h has risen by kLiftHeight_m in it
///   place     from when h is for the last time above its end by kLiftHeight_m, to the end of the
///             last transport
///   release   from there until the wrist has left by kReleaseDistance_m
///   retreat   from there until the wrist has left by kMaxHandDistance_m
///   home      from there to the end of the return
///
/// The last four only if a return follows, which shows that the target was put down. A thing that
/// is not raised so far, as one that slides, has neither lift nor place. A hand that `goes_on` to
/// the next grasp has no home: its return, which ends on the way, is release and retreat.
void add_task_phases(const HandRecord& hand, bool goes_on, Movement& movement);

}  // namespace morphe::segment
