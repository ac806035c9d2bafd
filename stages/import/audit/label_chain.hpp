#pragma once

#include <string>
#include <vector>

#include "stages/import/audit/exchanges.hpp"

namespace morphe::imports {

/// Returns the columns in which the parts of the arms, as wholes, follow each other on the shortest
/// way: the recorded ones, or those after exchanges of two parts with as many points. The way leads
/// from the shoulder along the arm to the fingertips, through the mean point of each part (cluster
/// or joint), and is the median over the frames of its length, for both arms together. An exchange
/// has to shorten it by more than kMinChainGain_m. Fewer than kMinChainFrames frames tell nothing.
Permutation shortest_chain(const Array2D<Vec3>& frames, const std::vector<std::string>& names);

}  // namespace morphe::imports
