#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// The columns of tracks: track k is in column source[k].
using Permutation = std::vector<std::size_t>;

/// Returns the permutation in which each track is in its own column.
Permutation identity_permutation(std::size_t size);
/// Returns the columns of the tracks that `inner` finds in the tracks of `outer`: outer[inner[k]].
Permutation compose(const Permutation& outer, const Permutation& inner);
/// Returns the cycles of two or more tracks, each from its lowest one on, [track, source[track],
/// …].
std::vector<std::vector<std::size_t>> cycles_of(const Permutation& source);

/// A moment from which tracks are in other columns: those that began in column k are in column
/// source[k], until the next exchange.
struct Exchange {
  std::size_t frame = 0;
  Permutation source;
};

/// Finds the frames at which two or more points jump to where the others were about to be. A point
/// is expected to move on with the velocity of its last two frames. The points of the exchange all
/// jump by at least 8 mm, and each of them continues the motion of another one at less than 0.3 of
/// its jump. Jumps that no exchange explains are ignored. Without exchanges the result is empty.
std::vector<Exchange> find_exchanges(const std::vector<double>& time,
                                     const Array2D<Vec3>& position);

/// Returns the positions with each track in the column in which it began.
Array2D<Vec3> undo_exchanges(const std::vector<Exchange>& exchanges, const Array2D<Vec3>& position);

/// Returns the columns of the tracks in a frame.
Permutation source_at(const std::vector<Exchange>& exchanges, std::size_t frame,
                      std::size_t track_count);

}  // namespace morphe::imports
