#pragma once

#include <cstddef>

#include "stages/import/guess/recorded_points.hpp"

namespace morphe::imports {

/// Returns the number of frames from one sample of a recording to the next, such that there are
/// about kMedianFrames samples.
std::size_t sample_step(std::size_t frames);

/// Returns recorded_points() of the frames 0, s, 2 s, … with the step s above.
RecordedPoints sampled_points(const Streams& streams, Side hand);

}  // namespace morphe::imports
