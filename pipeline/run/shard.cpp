#include "pipeline/run/shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "core/motion/input_error.hpp"

namespace morphe::run {
namespace {

constexpr int kMaxShardCount = 1000000;

bool parse_number(std::string_view text, int& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

int from_environment(const char* name) {
  const char* const text = std::getenv(name);
  int number = 0;
  if (!text || !parse_number(text, number))
    throw InputError(
        fmt::format("--shard slurm: {} is not set to a number; run it in a job array", name));
  return number;
}

Shard slurm_shard() {
  const int id = from_environment("SLURM_ARRAY_TASK_ID");
  const int first = from_environment("SLURM_ARRAY_TASK_MIN");
  const int last = from_environment("SLURM_ARRAY_TASK_MAX");
  const int count = from_environment("SLURM_ARRAY_TASK_COUNT");
  if (last - first + 1 != count)
    throw InputError(fmt::format(
        "--shard slurm: the array {}-{} has {} tasks; it must not have gaps", first, last, count));
  return {id - first + 1, count};
}

}  // namespace

Shard parse_shard(const std::string& text) {
  if (text == "slurm") return slurm_shard();
  Shard shard;
  const std::string_view view = text;
  const std::size_t slash = view.find('/');
  if (slash == std::string_view::npos || !parse_number(view.substr(0, slash), shard.index) ||
      !parse_number(view.substr(slash + 1), shard.count) || shard.count < 1 ||
      shard.count > kMaxShardCount || shard.index < 1 || shard.index > shard.count)
    throw InputError(fmt::format("--shard {}: must be I/N with 1 <= I <= N, or slurm", text));
  return shard;
}

std::string shard_text(const Shard& shard) {
  return fmt::format("{}/{}", shard.index, shard.count);
}

std::vector<int> assign_shards(const std::vector<std::size_t>& frames, int count) {
  std::vector<int> order(frames.size()), shard_of(frames.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](int i) { return frames[i]; });
  using Load = std::pair<std::size_t, int>;  // frames so far, index of the shard
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (int i = 1; i <= count; ++i) loads.emplace(0, i);
  for (const int demonstration : order) {
    const auto [load, shard] = loads.top();
    loads.pop();
    shard_of[demonstration] = shard;
    // A demonstration without any frame has a cost as well.
    loads.emplace(load + std::max<std::size_t>(1, frames[demonstration]), shard);
  }
  return shard_of;
}

}  // namespace morphe::run
