#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace morphe::run {

/// One of `count` parts of a dataset that are run apart; index counts from 1.
struct Shard {
  int index = 1, count = 1;
  bool operator==(const Shard&) const = default;
};

/// "3/16", or "slurm": the task of a job array, from SLURM_ARRAY_TASK_ID, _MIN, _MAX and _COUNT.
/// InputError for anything else and for arrays with gaps.
Shard parse_shard(const std::string& text);
std::string shard_text(const Shard& shard);

/// The shard, 1 … count, of each demonstration: the longest first, each to the shard that has the
/// fewest frames so far (the first of several). A function of its arguments alone.
std::vector<std::uint32_t> share_out(const std::vector<std::size_t>& frames, int count);

}  // namespace morphe::run
