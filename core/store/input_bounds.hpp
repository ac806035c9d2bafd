#pragma once

#include <string>

#include "core/motion/demonstration.hpp"

namespace morphe::store {

/// Returns the first reason why a demonstration cannot be processed in bounded time, "" if it can,
/// as "markers/time: row 3: must be greater than in the previous row". The bounds are
/// times         increasing, |t| <= 1e12 s, at most 100,000 per second on average; at most 6 hours
///               for the streams of the recording together, and for those of the calibration
/// coordinates   at most 1000 km; quaternions of a norm from 0.5 to 2. Those of streams may be NaN,
///               which means not observed; those of objects may not
/// sizes         of objects: positive, at most 10 km; body lengths: positive, at most 3 m
std::string bounds_violation(const Demonstration& demonstration);

}  // namespace morphe::store
