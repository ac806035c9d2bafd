#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace morphe::run {

/// One of `count` parts of a dataset that are planned separately; the index is counted from 1.
struct Shard {
  int index = 1, count = 1;
  bool operator==(const Shard&) const = default;
};

/// Parses "3/16", or "slurm" for the task of a job array given by SLURM_ARRAY_TASK_ID, _MIN, _MAX
/// and _COUNT. Throws InputError for any other text and for arrays with gaps.
Shard parse_shard(const std::string& text);
/// Returns the text that parse_shard() reads.
std::string shard_text(const Shard& shard);

/// Returns the shard, 1 … count, of each demonstration with these numbers of frames. In the order
/// of decreasing length, each demonstration goes to the first of the shards with the fewest frames.
std::vector<int> assign_shards(const std::vector<std::size_t>& frames, int count);

}  // namespace morphe::run
