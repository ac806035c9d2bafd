#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace morphe::run {

/// One of `count` parts of a dataset that are planned separately; the index is counted from 1.
struct Shard {
  /// The index of the part and the number of parts.
  int index = 1, count = 1;
  bool operator==(const Shard&) const = default;
};

/// Parses "3/16", or "slurm" for the task of a job array given by SLURM_ARRAY_TASK_ID, _MIN, _MAX
/// and _COUNT. Throws InputError for any other text and for arrays with gaps.
Shard parse_shard(const std::string& text);
/// Returns the text that parse_shard() reads.
std::string shard_text(const Shard& shard);

/// Assigns each demonstration to a shard, 1 … count: in order of decreasing length, each is given
/// to the shard with the fewest frames so far (the first of several). The result depends on the
/// arguments only.
std::vector<std::uint32_t> assign_shards(const std::vector<std::size_t>& frames, int count);

}  // namespace morphe::run
