#pragma once

namespace morphe::run {

/// Returns how many threads, at most `count`, can run at once beside this one, by starting and
/// ending them. TBB ends the process where a thread cannot be started. If `count` cannot, `error`
/// is the number of the system's error, else 0.
int startable_threads(int count, int& error);

}  // namespace morphe::run
